package lookout.panels;

import java.awt.Color;
import java.awt.Component;
import java.awt.event.ActionEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.ImageIO;
import javax.swing.JDesktopPane;
import javax.swing.JFrame;
import javax.swing.JInternalFrame;
import javax.swing.SwingUtilities;
import lcm.lcm.LCM;
import lcm.lcm.LCMEncodable;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import lookout.clutter_map_t;
import lookout.motion_elements_t;
import lookout.node_status_t;
import lookout.ospa_t;
import lookout.sonar_image_t;
import lookout.sonar_scan_t;
import lookout.track_list_t;
import lookout.track_t;
import lookout.vehicle_state_t;

/**
 * Opens every panel as lcm-spy does, sends messages over memq://, and looks for what they say at the pixels where it
 * must be. Usage: PanelTest [DIRECTORY for the screenshots]; needs a display, LCM_DEFAULT_URL=memq://.
 */
public final class PanelTest {
    private static final double RANGE = 100.0;
    private static final double FILL = 0.9;  // The share of the panel's smaller side that the range takes.

    private static final SpyPlugin[] PLUGINS = {new MapPlugin(), new ImagePlugin(), new OspaPlugin(), new StatusPlugin()};

    private static JDesktopPane desktop;
    private static String folder;

    private PanelTest() {}

    public static void main(String[] words) throws Exception {
        folder = words.length > 0 ? words[0] : null;
        JFrame window = new JFrame("panels");
        desktop = new JDesktopPane();
        SwingUtilities.invokeAndWait(() -> {
            window.add(desktop);
            window.setSize(500, 400);
            window.setVisible(true);
        });
        testNames();
        testEveryChannel();
        testMap();
        testMapOfImages();
        testClutterMap();
        testImage();
        testOspa();
        testStatus();
        System.out.println("passed");
        System.exit(0);
    }

    private static void check(boolean condition, String what) {
        System.out.println((condition ? "ok: " : "FAILED: ") + what);
        if (!condition) {
            System.exit(1);
        }
    }

    // --- as lcm-spy does ----------------------------------------------------------------------------------------

    private static LivePanel open(SpyPlugin plugin, String channel, long fingerprint) throws Exception {
        check(plugin.canHandle(fingerprint), plugin.getClass().getSimpleName() + " takes " + channel);
        ChannelData data = new ChannelData();
        data.name = channel;
        SwingUtilities.invokeAndWait(
                () -> plugin.getAction(desktop, data).actionPerformed(new ActionEvent(desktop, 0, "open")));
        Component inside = Arrays.stream(desktop.getAllFrames()[0].getContentPane().getComponents())
                .filter(LivePanel.class::isInstance).findFirst().orElseThrow();
        return (LivePanel) inside;
    }

    private static void close() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            for (JInternalFrame frame : desktop.getAllFrames()) {
                frame.dispose();
            }
        });
        check(desktop.getAllFrames().length == 0, "the panel closes");
    }

    private static void send(String channel, LCMEncodable message) throws Exception {
        LCM.getSingleton().publish(channel, message);
    }

    /** The panel as it stands once what was sent has been painted. */
    private static BufferedImage look(LivePanel panel, String name) throws Exception {
        Thread.sleep(400);
        BufferedImage image = new BufferedImage(panel.getWidth(), panel.getHeight(), BufferedImage.TYPE_INT_RGB);
        SwingUtilities.invokeAndWait(() -> panel.paint(image.getGraphics()));
        if (folder != null) {
            ImageIO.write(image, "png", new File(folder, name + ".png"));
        }
        return image;
    }

    private static boolean has(BufferedImage image, double x, double y, int reach, Color colour) {
        for (int dx = -reach; dx <= reach; dx++) {
            for (int dy = -reach; dy <= reach; dy++) {
                int at = image.getRGB((int) Math.round(x) + dx, (int) Math.round(y) + dy) & 0xffffff;
                if (at == (colour.getRGB() & 0xffffff)) {
                    return true;
                }
            }
        }
        return false;
    }

    // --- the tests ----------------------------------------------------------------------------------------------

    private static void testNames() {
        for (SpyPlugin plugin : PLUGINS) {
            check(plugin.getAction(null, null) != null, "its name can be read before there is a channel");
        }
        check(MapPanel.prefixOf("AUV1_GLOBAL_TRACKS").equals("AUV1_"), "a channel's prefix is known");
        check(new MapPlugin().canHandle(motion_elements_t.LCM_FINGERPRINT), "the map takes MOTION_ELEMENTS");
        check(!new MapPlugin().canHandle(ospa_t.LCM_FINGERPRINT), "the map leaves OSPA alone");
    }

    /** Each channel has the panel that docs/watching.md promises, and no second one; it opens before anything is heard, and closes. */
    private static void testEveryChannel() throws Exception {
        Map<String, Long> channels = new LinkedHashMap<>();
        channels.put("SONAR_SCAN", sonar_scan_t.LCM_FINGERPRINT);
        channels.put("TRACKS", track_list_t.LCM_FINGERPRINT);
        channels.put("MOTION_ELEMENTS", motion_elements_t.LCM_FINGERPRINT);
        channels.put("SONAR_IMAGE", sonar_image_t.LCM_FINGERPRINT);
        channels.put("GLOBAL_TRACKS", track_list_t.LCM_FINGERPRINT);
        channels.put("CLUTTER_MAP", clutter_map_t.LCM_FINGERPRINT);
        channels.put("OSPA", ospa_t.LCM_FINGERPRINT);
        channels.put("LOOKOUT_STATUS", node_status_t.LCM_FINGERPRINT);
        for (Map.Entry<String, Long> channel : channels.entrySet()) {
            SpyPlugin[] takers = Arrays.stream(PLUGINS).filter(each -> each.canHandle(channel.getValue())).toArray(SpyPlugin[]::new);
            check(takers.length == 1, channel.getKey() + " has one panel");
            open(takers[0], channel.getKey(), channel.getValue());
            close();
        }
    }

    private static vehicle_state_t vehicle(double heading) {
        vehicle_state_t state = new vehicle_state_t();
        state.heading = heading;
        return state;
    }

    private static sonar_scan_t scan() {
        sonar_scan_t scan = new sonar_scan_t();
        scan.num_beams = 90;
        scan.first_bearing = Math.toRadians(-44.5);
        scan.bearing_step = Math.toRadians(1.0);
        scan.max_range = RANGE;
        scan.num_returns = 1;
        scan.bearing = new double[] {0.0};
        scan.range = new double[] {90.0};
        scan.intensity = new double[] {1.0};
        return scan;
    }

    private static track_list_t track(int status, double north, double east) {
        track_t track = new track_t();
        track.id = 7;
        track.status = (byte) status;
        track.north = north;
        track.east = east;
        track.covariance[0][0] = 4.0;
        track.covariance[1][1] = 4.0;
        track_list_t list = new track_list_t();
        list.num_tracks = 1;
        list.tracks = new track_t[] {track};
        return list;
    }

    private static void testMap() throws Exception {
        LivePanel panel = open(new MapPlugin(), "TRACKS", track_list_t.LCM_FINGERPRINT);
        send("VEHICLE_STATE", vehicle(0.0));
        send("SONAR_SCAN", scan());
        send("TRACKS", track(1, 80.0, 20.0));
        BufferedImage image = look(panel, "map");
        double scale = FILL * Math.min(image.getWidth(), image.getHeight()) / RANGE;
        double x = image.getWidth() / 2.0;
        double y = image.getHeight() / 2.0;
        // The middle of the fan, 50 m ahead, stands in the middle of the panel; north is up.
        check(has(image, x + 20.0 * scale, y - 30.0 * scale, 2, MapPanel.STATUS_COLOURS[1]), "a confirmed track is where it must be");
        check(has(image, x + (20.0 + 2.0 * 2.448) * scale, y - 30.0 * scale, 2, MapPanel.STATUS_COLOURS[1]),
                "its 95 % ellipse is 2.448 sigma wide");
        check(!has(image, x - 20.0 * scale, y - 30.0 * scale, 4, MapPanel.STATUS_COLOURS[1]), "and not on the other side");
        check(bright(image, x, y - 40.0 * scale), "the return is drawn");
        ((MapPanel) panel).bowUp(true);
        send("VEHICLE_STATE", vehicle(Math.PI / 2.0));
        send("SONAR_SCAN", scan());
        send("TRACKS", track(2, 0.0, 80.0));
        image = look(panel, "map_bow_up");
        check(has(image, x, y - 30.0 * scale - 5.0, 3, MapPanel.STATUS_COLOURS[2]), "bow up, a track ahead stands above, a square");
        panel.pause(true);
        send("TRACKS", track(1, 80.0, 20.0));
        check(has(look(panel, "map_paused"), x, y - 30.0 * scale - 5.0, 3, MapPanel.STATUS_COLOURS[2]), "pause holds the picture");
        close();
        send("TRACKS", track(1, 80.0, 20.0));
    }

    private static void testMapOfImages() throws Exception {
        LivePanel panel = open(new MapPlugin(), "TRACKS", track_list_t.LCM_FINGERPRINT);
        sonar_image_t message = new sonar_image_t();
        message.num_beams = 3;
        message.num_bins = 100;
        message.first_range = 0.5;
        message.range_step = 1.0;
        message.bearing = new double[] {-0.2, 0.0, 0.2};
        message.intensity = new short[3][100];
        send("VEHICLE_STATE", vehicle(0.0));
        send("SONAR_IMAGE", message);
        send("TRACKS", track(1, 80.0, 20.0));
        BufferedImage image = look(panel, "map_images");
        double scale = FILL * Math.min(image.getWidth(), image.getHeight()) / RANGE;
        check(has(image, image.getWidth() / 2.0 + 20.0 * scale, image.getHeight() / 2.0 - 30.0 * scale, 2,
                MapPanel.STATUS_COLOURS[1]), "without scans the images give the fan: 100 m ahead fill the panel");
        close();
    }

    /** A sonar that looked east from 50 m north had one dense cell, 40 to 60 m ahead; it stands where it was then. */
    private static void testClutterMap() throws Exception {
        LivePanel panel = open(new MapPlugin(), "CLUTTER_MAP", clutter_map_t.LCM_FINGERPRINT);
        clutter_map_t map = new clutter_map_t();
        map.sonar_north = 50.0;
        map.sonar_heading = Math.PI / 2.0;
        map.first_bearing = -0.3;
        map.bearing_step = 0.2;
        map.range_step = 20.0;
        map.num_bearings = 3;
        map.num_ranges = 5;
        map.density = new byte[3][5];
        map.density[1][1] = 40;
        send("VEHICLE_STATE", vehicle(0.0));
        send("SONAR_SCAN", scan());
        send("CLUTTER_MAP", map);
        BufferedImage image = look(panel, "clutter");
        double scale = FILL * Math.min(image.getWidth(), image.getHeight()) / RANGE;
        double x = image.getWidth() / 2.0;
        double y = image.getHeight() / 2.0;
        check(orange(image, x + 30.0 * scale, y), "a dense cell of the clutter map is where it must be");
        check(!orange(image, x + 10.0 * scale, y) && !orange(image, x + 50.0 * scale, y), "and is no deeper");
        check(!orange(image, x, y - 30.0 * scale), "nor where the sonar looks now");
        send("TRACKS", late(track(1, 80.0, 20.0)));
        check(!orange(look(panel, "clutter_old"), x + 30.0 * scale, y), "an old clutter map is not shown");
        close();
    }

    private static track_list_t late(track_list_t list) {
        list.utime = 100_000_000L;
        return list;
    }

    private static boolean orange(BufferedImage image, double x, double y) {
        Color at = new Color(image.getRGB((int) Math.round(x), (int) Math.round(y)));
        return at.getRed() > 120 && at.getRed() > 2 * at.getBlue();
    }

    private static boolean bright(BufferedImage image, double x, double y) {
        for (int dx = -2; dx <= 2; dx++) {
            for (int dy = -2; dy <= 2; dy++) {
                Color at = new Color(image.getRGB((int) Math.round(x) + dx, (int) Math.round(y) + dy));
                if (Math.min(at.getRed(), Math.min(at.getGreen(), at.getBlue())) > 150) {
                    return true;
                }
            }
        }
        return false;
    }

    private static void testImage() throws Exception {
        LivePanel panel = open(new ImagePlugin(), "SONAR_IMAGE", sonar_image_t.LCM_FINGERPRINT);
        sonar_image_t message = new sonar_image_t();
        message.num_beams = 4;
        message.num_bins = 4;
        message.range_step = 1.0;
        message.bearing = new double[] {-0.3, -0.1, 0.1, 0.9};
        message.intensity = new short[4][4];
        message.intensity[3][3] = 1000;
        send("SONAR_IMAGE", message);
        BufferedImage image = look(panel, "image");
        int height = image.getHeight() - 18;
        Color strong = new Color(image.getRGB(image.getWidth() * 7 / 8, 18 + height / 8));
        check(strong.getRed() > 200, "the strongest echo, last beam and farthest bin, is bright at the right above");
        // The last beam reaches from .5 to 1.3 rad of the -.4 to 1.3 that the sector spans: nearly half of the width.
        Color inner = new Color(image.getRGB((int) (image.getWidth() * 0.58), 18 + height / 8));
        check(inner.getRed() > 200, "a beam is as wide as its bearings say");
        check(new Color(image.getRGB((int) (image.getWidth() * 0.45), 18 + height / 8)).getRed() < 50, "and no wider");
        check(new Color(image.getRGB(image.getWidth() / 8, image.getHeight() - height / 8)).getRed() < 50, "the rest is dark");
        close();
    }

    private static void testOspa() throws Exception {
        LivePanel panel = open(new OspaPlugin(), "OSPA", ospa_t.LCM_FINGERPRINT);
        for (int k = 0; k < 20; k++) {
            ospa_t report = new ospa_t();
            report.utime = k * 500_000L;
            report.cutoff = 20.0;
            report.total = 10.0;
            report.num_truth = 2;
            report.num_tracks = 1;
            send("OSPA", report);
        }
        BufferedImage image = look(panel, "ospa");
        int split = (int) (image.getHeight() * 0.62);
        check(bright(image, image.getWidth() / 2.0, 20 + (split - 20) / 2.0), "an OSPA of half the cut-off is half way up");
        close();
    }

    /** Whether a line of LivePanel.DAMAGED stands in the lower left corner; its letters are smoothed. */
    private static boolean saysDamaged(BufferedImage image) {
        for (int y = image.getHeight() - 24; y < image.getHeight(); y++) {
            for (int x = 0; x < 100; x++) {
                Color at = new Color(image.getRGB(x, y));
                if (at.getRed() > 180 && at.getGreen() < 150) {
                    return true;
                }
            }
        }
        return false;
    }

    private static void testStatus() throws Exception {
        LivePanel panel = open(new StatusPlugin(), "LOOKOUT_STATUS", node_status_t.LCM_FINGERPRINT);
        node_status_t status = new node_status_t();
        status.node_id = 1;
        status.node = "lookout track";
        status.last_error = "";
        send("LOOKOUT_STATUS", status);
        check(has(look(panel, "status_good"), 15, 12, 2, StatusPanel.GOOD), "the light of a healthy node is green");
        status.rejected = 5;
        status.last_error = "no pose";
        send("LOOKOUT_STATUS", status);
        check(has(look(panel, "status_doubt"), 15, 12, 2, StatusPanel.DOUBT), "yellow where it refuses messages");
        LCM.getSingleton().publish("LOOKOUT_STATUS", new byte[] {1, 2, 3}, 0, 3);
        Thread.sleep(3200);
        check(has(look(panel, "status_bad"), 15, 12, 2, StatusPanel.BAD), "red where it is silent");
        check(panel.damaged() == 1, "a damaged message is passed by and counted");
        check(saysDamaged(look(panel, "status_damaged")), "and the panel says so");
        close();
    }
}
