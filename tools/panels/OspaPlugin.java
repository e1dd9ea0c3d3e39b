package lookout.panels;

import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import lookout.ospa_t;

/** OSPA and the counts over time, on OSPA. */
public final class OspaPlugin implements SpyPlugin {
    @Override
    public boolean canHandle(long fingerprint) {
        return fingerprint == ospa_t.LCM_FINGERPRINT;
    }

    @Override
    public Action getAction(JDesktopPane desktop, ChannelData channel) {
        return PanelFrame.opener("Lookout OSPA", desktop, channel, OspaPanel::new);
    }
}
