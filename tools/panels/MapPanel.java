package lookout.panels;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import lookout.clutter_map_t;
import lookout.motion_element_t;
import lookout.motion_elements_t;
import lookout.sonar_image_t;
import lookout.sonar_scan_t;
import lookout.track_list_t;
import lookout.track_t;
import lookout.vehicle_state_t;

/** The fan with its returns, which fade, and the tracks: shape and colour by status, number, velocity, ellipse, trail. */
final class MapPanel extends LivePanel {
    static final Color[] STATUS_COLOURS = {new Color(0xf7dc6f), new Color(0x58d68d), new Color(0x85c1e9)};
    static final Color CLUTTER = new Color(0xe67e22);
    private static final String[] CHANNELS = {
        "SONAR_SCAN", "SONAR_IMAGE", "GLOBAL_TRACKS", "TRACKS", "MOTION_ELEMENTS", "CLUTTER_MAP"};
    private static final double FADE_S = 8.0;
    private static final double TRAIL_S = 30.0;
    private static final int MAX_SCANS = 160;
    private static final int MAX_POINTS = 700;  // Of a trail.
    private static final int MAX_TRAILS = 600;
    private static final double CHI_SQUARE_95 = -2.0 * Math.log(0.05);  // Of two degrees of freedom.
    private static final double AHEAD_S = 10.0;  // Length of a velocity's line.
    private static final double CLUTTER_VALID_S = 60.0;  // An older clutter map says nothing.
    private static final double LEAST_DB = 6.0;  // Density of clutter where its colour begins,
    private static final double MOST_DB = 25.0;  // and where it is full.

    private record Returns(long utime, double[] north, double[] east) {}

    private record Place(long utime, double north, double east) {}

    private final Deque<Returns> scans = new ArrayDeque<>();
    private final Map<Long, Deque<Place>> trails = new HashMap<>();
    private vehicle_state_t vehicle;
    private sonar_scan_t scan;
    private double[] edges;  // Bearings between the beams of the fan, null before there is one.
    private double range = 150.0;  // Of the fan.
    private double[] sonar = {0.0, 0.0, 0.0};  // North, east, heading of the sonar at the scan.
    private track_list_t tracks;
    private track_list_t globalTracks;
    private motion_elements_t elements;
    private clutter_map_t clutter;
    private boolean bowUp;
    private double zoom = 1.0;

    MapPanel(String channel) {
        String prefix = prefixOf(channel);
        listen(prefix + "VEHICLE_STATE", bytes -> vehicle = new vehicle_state_t(bytes));
        listen(prefix + "SONAR_SCAN", bytes -> takeScan(new sonar_scan_t(bytes)));
        listen(prefix + "SONAR_IMAGE", bytes -> takeImage(new sonar_image_t(bytes)));
        listen(prefix + "TRACKS", bytes -> takeTracks(new track_list_t(bytes)));
        listen("GLOBAL_TRACKS", bytes -> globalTracks = new track_list_t(bytes));
        listen(prefix + "MOTION_ELEMENTS", bytes -> elements = new motion_elements_t(bytes));
        listen(prefix + "CLUTTER_MAP", bytes -> clutter = new clutter_map_t(bytes));
        addMouseWheelListener(event -> {
            zoom = Math.min(50.0, Math.max(0.05, zoom * Math.pow(1.15, -event.getWheelRotation())));
            repaint();
        });
    }

    /** What stands before the channel's own name: the vehicle's prefix. */
    static String prefixOf(String channel) {
        for (String name : CHANNELS) {
            if (channel.endsWith(name)) {
                return channel.substring(0, channel.length() - name.length());
            }
        }
        return "";
    }

    void bowUp(boolean on) {
        bowUp = on;
        repaint();
    }

    private void placeSonar(double x, double y, double heading) {
        if (vehicle == null) {
            return;
        }
        double c = Math.cos(vehicle.heading);
        double s = Math.sin(vehicle.heading);
        sonar = new double[] {vehicle.north + c * x - s * y, vehicle.east + s * x + c * y, vehicle.heading + heading};
    }

    /** The fan of a sonar that sends images alone. */
    private void takeImage(sonar_image_t next) {
        if (scan != null || next.num_beams < 1) {
            return;
        }
        placeSonar(next.mount_x, next.mount_y, next.mount_heading);
        edges = BeamEdges.of(next.bearing);
        range = next.first_range + (next.num_bins - 0.5) * next.range_step;
    }

    private static double[] evenEdges(sonar_scan_t scan) {
        double[] edges = new double[scan.num_beams + 1];
        for (int beam = 0; beam <= scan.num_beams; beam++) {
            edges[beam] = scan.first_bearing + (beam - 0.5) * scan.bearing_step;
        }
        return edges;
    }

    private void takeScan(sonar_scan_t next) {
        scan = next;
        edges = evenEdges(next);
        range = next.max_range;
        placeSonar(next.mount_x, next.mount_y, next.mount_heading);
        double[] north = new double[next.num_returns];
        double[] east = new double[next.num_returns];
        for (int i = 0; i < next.num_returns; i++) {
            north[i] = sonar[0] + next.range[i] * Math.cos(sonar[2] + next.bearing[i]);
            east[i] = sonar[1] + next.range[i] * Math.sin(sonar[2] + next.bearing[i]);
        }
        if (!scans.isEmpty() && next.utime < scans.getLast().utime) {
            scans.clear();
        }
        scans.addLast(new Returns(next.utime, north, east));
        while (scans.size() > MAX_SCANS || next.utime - scans.getFirst().utime > FADE_S * 1e6) {
            scans.removeFirst();
        }
    }

    private void takeTracks(track_list_t list) {
        tracks = list;
        for (track_t track : list.tracks) {
            Deque<Place> trail = trails.computeIfAbsent(track.id, id -> new ArrayDeque<>());
            if (!trail.isEmpty() && list.utime < trail.getLast().utime) {
                trail.clear();
            }
            trail.addLast(new Place(list.utime, track.north, track.east));
        }
        for (Deque<Place> trail : trails.values()) {
            while (!trail.isEmpty()
                    && (trail.size() > MAX_POINTS || Math.abs(list.utime - trail.getFirst().utime) > TRAIL_S * 1e6)) {
                trail.removeFirst();
            }
        }
        trails.values().removeIf(Deque::isEmpty);
        if (trails.size() > MAX_TRAILS) {
            trails.clear();
        }
    }

    // --- geometry -----------------------------------------------------------------------------------------------

    private double pixelsPerMetre() {
        return 0.9 * Math.min(getWidth(), getHeight()) / range * zoom;
    }

    private double turn() {
        return bowUp && vehicle != null ? -vehicle.heading : 0.0;
    }

    /** Where a place of the earth is on the panel: the middle of the fan stands in the middle. */
    Point2D toScreen(double north, double east) {
        double middle = edges == null ? 0.0 : 0.5 * (edges[0] + edges[edges.length - 1]);
        double dn = north - (sonar[0] + 0.5 * range * Math.cos(sonar[2] + middle));
        double de = east - (sonar[1] + 0.5 * range * Math.sin(sonar[2] + middle));
        double up = dn * Math.cos(turn()) - de * Math.sin(turn());
        double right = dn * Math.sin(turn()) + de * Math.cos(turn());
        return new Point2D.Double(getWidth() / 2.0 + right * pixelsPerMetre(), getHeight() / 2.0 - up * pixelsPerMetre());
    }

    // --- painting -----------------------------------------------------------------------------------------------

    @Override
    void paintPicture(Graphics2D g) {
        paintFan(g);
        paintClutter(g);
        paintReturns(g);
        paintElements(g);
        for (track_list_t list : new track_list_t[] {globalTracks, tracks}) {
            if (list != null) {
                for (track_t track : list.tracks) {
                    paintTrack(g, track);
                }
            }
        }
        paintVehicle(g);
        g.setColor(TEXT);
        g.drawString((bowUp ? "bow up" : "north up") + (tracks == null ? "" : String.format("   t = %.1f s", tracks.utime * 1e-6)), 8, 14);
    }

    private static void extend(Path2D path, Point2D to) {
        if (path.getCurrentPoint() == null) {
            path.moveTo(to.getX(), to.getY());
        } else {
            path.lineTo(to.getX(), to.getY());
        }
    }

    private void paintFan(Graphics2D g) {
        if (edges == null) {
            return;
        }
        Path2D fan = new Path2D.Double();
        extend(fan, toScreen(sonar[0], sonar[1]));
        for (double edge : edges) {
            double angle = sonar[2] + edge;
            extend(fan, toScreen(sonar[0] + range * Math.cos(angle), sonar[1] + range * Math.sin(angle)));
        }
        fan.closePath();
        g.setColor(new Color(0x12283a));
        g.fill(fan);
        g.setColor(new Color(0x2d5573));
        g.draw(fan);
    }

    /** What the tracker has learnt of its clutter, where the sonar was then, while it holds. */
    private void paintClutter(Graphics2D g) {
        if (clutter == null || (tracks != null && Math.abs(tracks.utime - clutter.utime) > CLUTTER_VALID_S * 1e6)) {
            return;
        }
        for (int i = 0; i < clutter.num_bearings; i++) {
            for (int j = 0; j < clutter.num_ranges; j++) {
                double share = Math.min(1.0, (clutter.density[i][j] - LEAST_DB + 1.0) / (MOST_DB - LEAST_DB));
                if (share > 0.0) {
                    g.setColor(new Color(CLUTTER.getRed(), CLUTTER.getGreen(), CLUTTER.getBlue(), (int) (40 + 150 * share)));
                    g.fill(cellOf(clutter, i, j));
                }
            }
        }
    }

    private Path2D cellOf(clutter_map_t map, int bearing, int range) {
        double left = map.sonar_heading + map.first_bearing + bearing * map.bearing_step;
        double near = range * map.range_step;
        double far = near + map.range_step;
        Path2D cell = new Path2D.Double();
        for (double[] corner : new double[][] {{near, left}, {far, left}, {far, left + map.bearing_step}, {near, left + map.bearing_step}}) {
            extend(cell, toScreen(map.sonar_north + corner[0] * Math.cos(corner[1]), map.sonar_east + corner[0] * Math.sin(corner[1])));
        }
        cell.closePath();
        return cell;
    }

    private void paintReturns(Graphics2D g) {
        for (Returns returns : scans) {
            double age = (scans.getLast().utime - returns.utime) * 1e-6;
            int alpha = age == 0.0 ? 240 : (int) (110 * Math.max(0.0, 1.0 - age / FADE_S));
            g.setColor(new Color(255, 255, 255, alpha));
            for (int i = 0; i < returns.north.length; i++) {
                Point2D at = toScreen(returns.north[i], returns.east[i]);
                g.fill(new Rectangle2D.Double(at.getX() - 1, at.getY() - 1, 2, 2));
            }
        }
    }

    private void paintElements(Graphics2D g) {
        if (elements == null) {
            return;
        }
        g.setColor(new Color(195, 155, 211, 180));
        for (motion_element_t element : elements.elements) {
            Point2D at = toScreen(element.north, element.east);
            g.draw(new Rectangle2D.Double(at.getX() - 3, at.getY() - 3, 6, 6));
        }
    }

    private void paintTrack(Graphics2D g, track_t track) {
        Color colour = track.status >= 0 && track.status < STATUS_COLOURS.length ? STATUS_COLOURS[track.status] : Color.WHITE;
        Point2D at = toScreen(track.north, track.east);
        paintTrail(g, track, colour);
        g.setColor(colour);
        paintEllipse(g, track);
        Point2D ahead = toScreen(track.north + AHEAD_S * track.north_velocity, track.east + AHEAD_S * track.east_velocity);
        g.setStroke(new BasicStroke(1.5f));
        g.draw(new Line2D.Double(at, ahead));
        Shape shape = shapeOf(track.status, at.getX(), at.getY());
        if (track.status == 1) {
            g.fill(shape);
        } else {
            g.setStroke(new BasicStroke(2f));
            g.draw(shape);
        }
        g.drawString(Long.toString(track.id), (float) at.getX() + 8, (float) at.getY() - 6);
    }

    private static Shape shapeOf(int status, double x, double y) {
        if (status == 1) {
            return new Ellipse2D.Double(x - 5, y - 5, 10, 10);
        }
        if (status == 2) {
            return new Rectangle2D.Double(x - 5, y - 5, 10, 10);
        }
        Path2D triangle = new Path2D.Double();
        triangle.moveTo(x, y - 6);
        triangle.lineTo(x + 6, y + 5);
        triangle.lineTo(x - 6, y + 5);
        triangle.closePath();
        return triangle;
    }

    private void paintTrail(Graphics2D g, track_t track, Color colour) {
        Deque<Place> trail = trails.get(track.id);
        if (trail == null || trail.size() < 2) {
            return;
        }
        Path2D path = new Path2D.Double();
        trail.forEach(place -> extend(path, toScreen(place.north, place.east)));
        g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 140));
        g.setStroke(new BasicStroke(1.5f));
        g.draw(path);
    }

    /** The 95 % ellipse of the position, from the eigenvalues of its covariance. */
    private void paintEllipse(Graphics2D g, track_t track) {
        double nn = track.covariance[0][0];
        double ne = track.covariance[0][1];
        double ee = track.covariance[1][1];
        double mean = 0.5 * (nn + ee);
        double spread = Math.hypot(0.5 * (nn - ee), ne);
        if (!(mean - spread >= 0.0) || !Double.isFinite(mean + spread)) {
            return;
        }
        double major = Math.sqrt(CHI_SQUARE_95 * (mean + spread));
        double minor = Math.sqrt(CHI_SQUARE_95 * (mean - spread));
        double heading = 0.5 * Math.atan2(2.0 * ne, nn - ee);
        Path2D path = new Path2D.Double();
        for (int i = 0; i <= 40; i++) {
            double a = major * Math.cos(i * Math.PI / 20.0);
            double b = minor * Math.sin(i * Math.PI / 20.0);
            extend(path, toScreen(track.north + a * Math.cos(heading) - b * Math.sin(heading),
                    track.east + a * Math.sin(heading) + b * Math.cos(heading)));
        }
        g.setStroke(new BasicStroke(1f));
        g.draw(path);
    }

    private void paintVehicle(Graphics2D g) {
        if (vehicle == null) {
            return;
        }
        Point2D at = toScreen(vehicle.north, vehicle.east);
        Graphics2D turned = (Graphics2D) g.create();
        turned.translate(at.getX(), at.getY());
        turned.rotate(vehicle.heading + turn());
        Path2D hull = new Path2D.Double();
        hull.moveTo(0, -9);
        hull.lineTo(5, 6);
        hull.lineTo(-5, 6);
        hull.closePath();
        turned.setColor(new Color(0x5dade2));
        turned.fill(hull);
        turned.dispose();
    }
}
