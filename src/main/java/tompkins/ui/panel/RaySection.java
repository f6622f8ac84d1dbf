package tompkins.ui.panel;

import java.awt.Rectangle;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import tompkins.ui.picture.PixelProbe;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Rows;
import tompkins.ui.widget.Section;
import tompkins.ui.widget.Texts;

/** The life of the ray of a pinned pixel, in a part of the side panel that is there only while a pixel is pinned. */
public final class RaySection {

    private final JPanel content = Rows.column();
    private final Note story = Note.selectable();
    private final Section section;

    /** A section; {@code unpin} is called by its button. */
    public RaySection(Runnable unpin) {
        story.component().setName("ray.story");
        story.component().getAccessibleContext().setAccessibleName(Texts.get("ray.title"));
        JButton button = new JButton(Texts.get("ray.unpin"));
        button.setName(Texts.get("ray.unpin"));
        button.addActionListener(event -> unpin.run());
        content.add(story.component(), "wmin 0");
        content.add(button, "growx 0");
        section = new Section(Texts.get("ray.title"), content, true);
        section.component().setVisible(false);
    }

    /** The section itself. */
    public JComponent component() {
        return section.component();
    }

    /**
     * Shows a ray, or nothing if it is null. The first one is scrolled into view; later ones leave the panel where it
     * is, for somebody may be using another part of it while clicking.
     *
     * @param picture what the picture is called that the ray belongs to, or null if it is the studio's
     */
    public void show(PixelProbe.Reading reading, String picture) {
        boolean isFirst = reading != null && !section.component().isVisible();
        section.component().setVisible(reading != null);
        if (isFirst) {
            // later, when it has its place
            SwingUtilities.invokeLater(this::scrollIntoView);
        }
        if (reading != null) {
            String heading = picture == null ? "" : Texts.get("ray.other", picture) + "\n";
            story.setText(heading + String.join("\n", PixelProbe.story(reading)));
        }
    }

    private void scrollIntoView() {
        JComponent component = section.component();
        component.scrollRectToVisible(new Rectangle(component.getSize()));
    }
}
