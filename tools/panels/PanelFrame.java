package lookout.panels;

import java.awt.BorderLayout;
import java.awt.event.ActionEvent;
import java.util.function.Function;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import javax.swing.JInternalFrame;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;
import javax.swing.event.InternalFrameAdapter;
import javax.swing.event.InternalFrameEvent;
import lcm.spy.ChannelData;

/** The window of a panel inside lcm-spy. */
final class PanelFrame extends JInternalFrame {
    // The spy's desktop measures 500 x 400 and cuts off what is larger.
    private static final int WIDTH = 470;
    private static final int HEIGHT = 350;

    private PanelFrame(String title, LivePanel panel) {
        super(title, true, true, true, true);
        JToolBar tools = new JToolBar();
        tools.setFloatable(false);
        addButton(tools, "Pause", panel::pause);
        if (panel instanceof MapPanel map) {
            addButton(tools, "Bow up", map::bowUp);
        }
        add(tools, BorderLayout.NORTH);
        add(panel, BorderLayout.CENTER);
        setSize(WIDTH, HEIGHT);
        addInternalFrameListener(new InternalFrameAdapter() {
            @Override
            public void internalFrameClosed(InternalFrameEvent event) {
                panel.close();
            }
        });
    }

    private static void addButton(JToolBar tools, String text, java.util.function.Consumer<Boolean> change) {
        JToggleButton button = new JToggleButton(text);
        button.addActionListener(event -> change.accept(button.isSelected()));
        tools.add(button);
    }

    /** The action that opens a panel on a channel; the spy asks for it once with nothing, to read its name. */
    static Action opener(String name, JDesktopPane desktop, ChannelData channel, Function<String, LivePanel> make) {
        return new AbstractAction(name) {
            @Override
            public void actionPerformed(ActionEvent event) {
                PanelFrame frame = new PanelFrame(name + ": " + channel.name, make.apply(channel.name));
                desktop.add(frame);
                frame.setVisible(true);
                frame.moveToFront();
            }
        };
    }
}
