package lookout.panels;

import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import lookout.sonar_image_t;

/** The image, on SONAR_IMAGE. */
public final class ImagePlugin implements SpyPlugin {
    @Override
    public boolean canHandle(long fingerprint) {
        return fingerprint == sonar_image_t.LCM_FINGERPRINT;
    }

    @Override
    public Action getAction(JDesktopPane desktop, ChannelData channel) {
        return PanelFrame.opener("Lookout image", desktop, channel, ImagePanel::new);
    }
}
