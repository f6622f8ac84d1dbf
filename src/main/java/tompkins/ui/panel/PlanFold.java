package tompkins.ui.panel;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JPanel;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Rows;

/** What the picture models and what it leaves out, in sentences. */
public final class PlanFold {

    private final JPanel panel = Rows.column();

    /**
     * Kept from picture to picture, because a new note takes the event thread a millisecond, but a new text almost
     * nothing.
     */
    private final List<Note> notes = new ArrayList<>();

    /** The sentences, to be put into a panel. */
    public JComponent component() {
        return panel;
    }

    /** Shows sentences, and warnings first. */
    public void show(List<String> sentences, List<String> warnings) {
        setCount(warnings.size() + sentences.size());
        for (int i = 0; i < warnings.size(); i++) {
            notes.get(i).setError(warnings.get(i));
        }
        for (int i = 0; i < sentences.size(); i++) {
            notes.get(warnings.size() + i).setText(sentences.get(i));
        }
    }

    private void setCount(int count) {
        while (notes.size() < count) {
            Note note = new Note("");
            notes.add(note);
            panel.add(note.component(), "wmin 0");
        }
        while (notes.size() > count) {
            panel.remove(notes.remove(notes.size() - 1).component());
        }
        panel.revalidate();
        panel.repaint();
    }
}
