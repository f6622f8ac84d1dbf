package tompkins.ui.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JTextArea;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import tompkins.ui.widget.Look;

class PlanFoldTest {

    private final PlanFold fold = new PlanFold();

    @BeforeAll
    static void look() {
        Look.LIGHT.install();
    }

    private List<String> texts() {
        return notes().map(JTextArea::getText).toList();
    }

    private Stream<JTextArea> notes() {
        return Stream.of(fold.component().getComponents())
                .filter(Component::isVisible)
                .map(JTextArea.class::cast);
    }

    @Test
    void warningsComeFirstAndSentencesGoAgain() {
        fold.show(List.of("one", "two"), List.of());
        assertThat(texts()).containsExactly("one", "two");
        fold.show(List.of("three"), List.of("careful", "slow"));
        assertThat(texts()).containsExactly("\u26A0 careful", "\u26A0 slow", "three");
        fold.show(List.of("four"), List.of());
        assertThat(texts()).containsExactly("four");
    }

    @Test
    void theNotesStayWhenTheirTextsChange() {
        fold.show(List.of("one", "two"), List.of());
        List<JTextArea> before = notes().toList();
        fold.show(List.of("one", "three"), List.of());
        assertThat(notes()).containsExactlyElementsOf(before);
        assertThat(texts()).containsExactly("one", "three");
    }
}
