package lookout.panels;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import lcm.lcm.LCM;
import lcm.lcm.LCMDataInputStream;
import lcm.lcm.LCMSubscriber;

/** A panel that listens to channels and paints what it heard last, at most twenty times a second. */
abstract class LivePanel extends JPanel {
    static final Color BACKGROUND = new Color(0x08, 0x11, 0x19);
    static final Color TEXT = new Color(0xdc, 0xe6, 0xee);
    static final Color DAMAGED = new Color(0xff, 0x7f, 0x6e);
    private static final int REPAINT_MS = 50;

    /** What is done with a message; it may throw on a damaged one, which is then passed by, counted and told. */
    interface Take {
        void message(LCMDataInputStream bytes) throws Exception;
    }

    private record Subscription(String channel, LCMSubscriber subscriber) {}

    private final List<Subscription> subscriptions = new ArrayList<>();
    private final Timer timer = new Timer(REPAINT_MS, event -> repaintIfNew());
    private boolean paused;
    private boolean isNew;
    private long damaged;

    LivePanel() {
        setBackground(BACKGROUND);
        timer.start();
    }

    /** Messages are decoded where they come in and handed to the painting thread, which alone holds the picture. */
    final void listen(String channel, Take take) {
        LCMSubscriber subscriber = (lcm, name, bytes) -> {
            byte[] copy = new byte[bytes.available()];
            try {
                bytes.readFully(copy);
            } catch (java.io.IOException error) {
                SwingUtilities.invokeLater(this::countDamaged);
                return;
            }
            SwingUtilities.invokeLater(() -> take(take, copy));
        };
        subscriptions.add(new Subscription(channel, subscriber));
        // LCM reads a channel's name as a regular expression.
        LCM.getSingleton().subscribe(java.util.regex.Pattern.quote(channel), subscriber);
    }

    private void take(Take take, byte[] bytes) {
        if (paused) {
            return;
        }
        try {
            take.message(new LCMDataInputStream(bytes));
            isNew = true;
        } catch (Exception | OutOfMemoryError error) {
            countDamaged();
        }
    }

    private void countDamaged() {
        damaged++;
        isNew = true;
    }

    private void repaintIfNew() {
        if (isNew) {
            isNew = false;
            repaint();
        }
    }

    final void pause(boolean on) {
        paused = on;
    }

    final long damaged() {
        return damaged;
    }

    /** Listens no more. */
    final void close() {
        timer.stop();
        for (Subscription subscription : subscriptions) {
            LCM.getSingleton().unsubscribe(java.util.regex.Pattern.quote(subscription.channel), subscription.subscriber);
        }
        subscriptions.clear();
        closed();
    }

    /** What else is to be stopped. */
    void closed() {}

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(TEXT);
        paintPicture(g);
        if (damaged > 0) {
            g.setColor(DAMAGED);
            g.drawString(damaged + (damaged == 1 ? " damaged message" : " damaged messages") + " passed by", 8, getHeight() - 8);
        }
        g.dispose();
    }

    abstract void paintPicture(Graphics2D g);
}
