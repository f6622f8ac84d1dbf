package tompkins.ui;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JPanel;

/** What the picture models and what it leaves out, in sentences. */
final class PlanFold {

    private final JPanel panel = Rows.column();
    private List<String> shown = List.of();

    JComponent component() {
        return panel;
    }

    /** Shows sentences, and warnings first. */
    void show(List<String> sentences, List<String> warnings) {
        List<String> all = new ArrayList<>(warnings);
        all.addAll(sentences);
        if (all.equals(shown)) {
            return;
        }
        shown = all;
        panel.removeAll();
        for (String warning : warnings) {
            Note note = new Note("");
            note.setError(warning);
            panel.add(note.component(), "wmin 0");
        }
        sentences.forEach(sentence -> panel.add(new Note(sentence).component(), "wmin 0"));
        panel.revalidate();
        panel.repaint();
    }
}
