package lookout.panels;

import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import lookout.clutter_map_t;
import lookout.motion_elements_t;
import lookout.sonar_scan_t;
import lookout.track_list_t;

/** The map, on SONAR_SCAN, TRACKS, GLOBAL_TRACKS, MOTION_ELEMENTS and CLUTTER_MAP. */
public final class MapPlugin implements SpyPlugin {
    @Override
    public boolean canHandle(long fingerprint) {
        return fingerprint == sonar_scan_t.LCM_FINGERPRINT || fingerprint == track_list_t.LCM_FINGERPRINT
                || fingerprint == motion_elements_t.LCM_FINGERPRINT || fingerprint == clutter_map_t.LCM_FINGERPRINT;
    }

    @Override
    public Action getAction(JDesktopPane desktop, ChannelData channel) {
        return PanelFrame.opener("Lookout map", desktop, channel, MapPanel::new);
    }
}
