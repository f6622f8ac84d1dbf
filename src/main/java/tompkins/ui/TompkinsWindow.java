package tompkins.ui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.WindowConstants;
import tompkins.studio.Studio;

/** The window of Tompkins: the photograph, and a narrow panel with what it depends on. */
public final class TompkinsWindow {

    private static final int PANEL_WIDTH = 330;

    private final JFrame frame = new JFrame();
    private final StudioModel model;
    private final PhotographView view;
    private final SidePanel side;
    private final StatusBar status;

    private TompkinsWindow(Studio studio, Path file) {
        model = new StudioModel(studio, file);
        view = new PhotographView(model, new PictureListener());
        side = new SidePanel(model, view);
        status = new StatusBar(view.controller());
        frame.setContentPane(content());
        frame.setName("tompkins");
        frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                status.stop();
                view.close();
            }
        });
        frame.setSize(new Dimension(UIScale.scale(1240), UIScale.scale(800)));
        frame.setMinimumSize(new Dimension(UIScale.scale(760), UIScale.scale(480)));
        frame.setLocationByPlatform(true);
        model.addListener(this::showTitle);
        showTitle();
    }

    /** Opens a window; it shows its first picture as soon as that is there. Called by any thread. */
    public static void open(Studio studio, Path file) {
        SwingUtilities.invokeLater(() -> {
            Look.LIGHT.install();
            TompkinsWindow window = new TompkinsWindow(studio, file);
            window.frame.setVisible(true);
            window.view.render();
        });
    }

    private JComponent content() {
        JPanel content = new JPanel(new BorderLayout());
        content.add(view.canvas(), BorderLayout.CENTER);
        JComponent panel = side.component();
        panel.setPreferredSize(new Dimension(UIScale.scale(PANEL_WIDTH), 0));
        panel.setBorder(BorderFactory.createMatteBorder(0, 1, 0, 0, UIManager.getColor("Tompkins.line")));
        content.add(panel, BorderLayout.EAST);
        content.add(status.component(), BorderLayout.SOUTH);
        return content;
    }

    private void showTitle() {
        String name = model.studio().title();
        frame.setTitle((model.isModified() ? "\u2022 " : "") + name + " \u2013 Tompkins");
    }

    private final class PictureListener implements PhotographView.Listener {

        @Override
        public void shown(Picture picture) {
            side.show(picture);
            status.show(picture);
        }

        @Override
        public void read(PixelProbe.Reading reading) {
            status.show(reading);
        }

        @Override
        public void pinned(PixelProbe.Reading reading) {
            side.show(reading);
        }

        @Override
        public void failed(String message) {
            status.say(message);
        }
    }
}
