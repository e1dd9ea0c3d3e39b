package lookout.panels;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.ToDoubleFunction;
import lookout.ospa_t;

/** OSPA with its parts over the last scans, and below it how many targets and tracks there were. */
final class OspaPanel extends LivePanel {
    private static final int KEPT = 400;
    private static final double SHARE_OF_DISTANCE = 0.62;  // Of the height.

    private final Deque<ospa_t> reports = new ArrayDeque<>();

    OspaPanel(String channel) {
        listen(channel, bytes -> take(new ospa_t(bytes)));
    }

    private void take(ospa_t report) {
        if (!reports.isEmpty() && report.utime < reports.getLast().utime) {
            reports.clear();
        }
        reports.addLast(report);
        if (reports.size() > KEPT) {
            reports.removeFirst();
        }
    }

    @Override
    void paintPicture(Graphics2D g) {
        if (reports.isEmpty()) {
            g.drawString("no OSPA yet; `lookout score` publishes it", 8, 14);
            return;
        }
        ospa_t last = reports.getLast();
        int split = (int) (getHeight() * SHARE_OF_DISTANCE);
        double most = reports.stream().mapToDouble(r -> Math.max(r.num_truth, r.num_tracks)).max().orElse(1.0);
        curve(g, r -> r.cardinality, last.cutoff, 20, split, new Color(0xff7f6e));
        curve(g, r -> r.localization, last.cutoff, 20, split, new Color(0x5dade2));
        curve(g, r -> r.total, last.cutoff, 20, split, Color.WHITE);
        curve(g, r -> r.num_truth, Math.max(1.0, most), split + 24, getHeight() - 4, new Color(0x8fa6b5));
        curve(g, r -> r.num_tracks, Math.max(1.0, most), split + 24, getHeight() - 4, new Color(0x58d68d));
        g.setColor(TEXT);
        g.drawString(String.format("OSPA %.2f m (white): localization %.2f (blue), cardinality %.2f (red)",
                last.total, last.localization, last.cardinality), 8, 14);
        g.drawString(String.format("%d targets (grey), %d tracks (green)", last.num_truth, last.num_tracks), 8, split + 16);
    }

    private void curve(Graphics2D g, ToDoubleFunction<ospa_t> value, double top, int above, int below, Color colour) {
        double first = reports.getFirst().utime;
        double span = Math.max(1.0, reports.getLast().utime - first);
        Path2D path = new Path2D.Double();
        for (ospa_t report : reports) {
            double x = 4 + (report.utime - first) / span * (getWidth() - 8);
            double y = below - Math.min(1.0, value.applyAsDouble(report) / top) * (below - above);
            if (path.getCurrentPoint() == null) {
                path.moveTo(x, y);
            }
            path.lineTo(x, y);
        }
        g.setColor(colour);
        g.draw(path);
    }
}
