package lookout.panels;

import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import lookout.node_status_t;

/** The traffic light, on LOOKOUT_STATUS. */
public final class StatusPlugin implements SpyPlugin {
    @Override
    public boolean canHandle(long fingerprint) {
        return fingerprint == node_status_t.LCM_FINGERPRINT;
    }

    @Override
    public Action getAction(JDesktopPane desktop, ChannelData channel) {
        return PanelFrame.opener("Lookout status", desktop, channel, StatusPanel::new);
    }
}
