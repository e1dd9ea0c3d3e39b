package lookout.panels;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.swing.Timer;
import lookout.node_status_t;

/** A traffic light for every node with its figures and, where it is not green, the reasons. */
final class StatusPanel extends LivePanel {
    static final Color GOOD = new Color(0x58d68d);
    static final Color DOUBT = new Color(0xf7dc6f);
    static final Color BAD = new Color(0xff7f6e);
    private static final double SILENCE_S = 3.0;   // A node speaks every second.
    private static final double SLOW_MS = 500.0;   // Of the p99 latency: the period of a common sonar.
    private static final int MAX_NODES = 16;
    private static final int MAX_TEXT = 80;
    private static final int LINE = 16;

    private static final class Heard {
        node_status_t status;
        long at;
        long firstRejected;
    }

    private final Map<String, Heard> nodes = new TreeMap<>();
    private final Timer second = new Timer(1000, event -> repaint());

    StatusPanel(String channel) {
        listen(channel, bytes -> take(new node_status_t(bytes)));
        second.start();
    }

    private void take(node_status_t status) {
        String key = cut(status.node) + " " + status.node_id;
        if (nodes.size() >= MAX_NODES && !nodes.containsKey(key)) {
            return;
        }
        Heard heard = nodes.computeIfAbsent(key, k -> new Heard());
        if (heard.status == null || status.rejected < heard.firstRejected) {
            heard.firstRejected = status.rejected;
        }
        heard.status = status;
        heard.at = System.nanoTime();
    }

    private static String cut(String text) {
        return text.length() > MAX_TEXT ? text.substring(0, MAX_TEXT) : text;
    }

    private static double age(Heard heard) {
        return (System.nanoTime() - heard.at) * 1e-9;
    }

    private static List<String> reasons(Heard heard) {
        List<String> reasons = new ArrayList<>();
        if (age(heard) > SILENCE_S) {
            reasons.add(String.format("silent for %.0f s", age(heard)));
        }
        if (heard.status.rejected > heard.firstRejected) {
            reasons.add(String.format("refused %d messages while watched: %s",
                    heard.status.rejected - heard.firstRejected, cut(heard.status.last_error)));
        }
        if (heard.status.latency_ms_p99 > SLOW_MS) {
            reasons.add(String.format("p99 latency %.0f ms", heard.status.latency_ms_p99));
        }
        return reasons;
    }

    @Override
    void closed() {
        second.stop();
    }

    @Override
    void paintPicture(Graphics2D g) {
        int y = LINE;
        for (Map.Entry<String, Heard> entry : nodes.entrySet()) {
            List<String> reasons = reasons(entry.getValue());
            node_status_t status = entry.getValue().status;
            g.setColor(reasons.isEmpty() ? GOOD : age(entry.getValue()) > SILENCE_S ? BAD : DOUBT);
            g.fillOval(8, y - 11, 14, 14);
            g.setColor(TEXT);
            g.setFont(g.getFont().deriveFont(Font.BOLD));
            g.drawString(entry.getKey() + (reasons.isEmpty() ? ": healthy" : ": not healthy"), 30, y);
            g.setFont(g.getFont().deriveFont(Font.PLAIN));
            g.drawString(String.format("taken %d, refused %d, lost %d; latency p50 %.1f ms, p99 %.1f ms", status.accepted,
                    status.rejected, status.dropped, status.latency_ms_p50, status.latency_ms_p99), 30, y += LINE);
            for (String reason : reasons) {
                g.drawString("! " + reason, 30, y += LINE);
            }
            y += LINE + LINE / 2;
        }
    }
}
