package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.awt.Container;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.studio.StudioNumber;
import tompkins.ui.Components;
import tompkins.ui.editor.RecordForm;

/**
 * A number is declared once, in its record: scene files, {@code --set}, {@code --number}, forms and the reference of
 * scene files find it there with its meaning, its unit and its range. Shown with a record that none of them knows.
 */
class DeclaredOnceTest {

    private static final Path HERE = Path.of("");

    /** As a camera might have it. */
    @Meaning("How the corners of the picture darken")
    public record Vignetting(
            @Meaning("Part of the light that the corners lose, 0 to 1")
            double strength,

            @Meaning(value = "Distance from the middle at which it begins", unit = "length")
            double start,

            @Meaning("How many steps it has, 1 to 9") int steps) {

        public static final Vignetting DEFAULT = new Vignetting(0, 1, 3);

        public Vignetting {
            Require.within("strength", strength, 0.0, 1.0);
            Require.distance("start", start);
            Require.within("steps", steps, 1, 9);
        }
    }

    private static Vignetting inFile(String text) {
        Problems problems = new Problems("f");
        DescriptionReader reader = new DescriptionReader(problems, new SceneFolder(HERE));
        Object read =
                reader.record(Vignetting.class, JsonParsing.parse(text, problems), "", List.of(), Vignetting.DEFAULT);
        problems.throwIfAny();
        return (Vignetting) read;
    }

    private static Vignetting set(String path, String value) {
        return Assignments.changed(Vignetting.DEFAULT, List.of(new Assignment("--set", path, value)), HERE);
    }

    @Test
    void sceneFilesReadAndWriteIt() {
        Vignetting vignetting = new Vignetting(0.25, 1, 4);
        assertThat(inFile("{\"strength\": 0.25, \"steps\": 4}")).isEqualTo(vignetting);
        Object tree = new DescriptionWriter(file -> false).tree(Vignetting.class, vignetting);
        assertThat(JsonLayout.line(tree)).isEqualTo("{\"strength\": 0.25, \"steps\": 4}");
    }

    @Test
    void setFindsItWithTheMessagesOfTheFile() {
        assertThat(set("strength", "0.25")).isEqualTo(new Vignetting(0.25, 1, 3));
        String[][] mistakes = {
            {"strength", "1.5", "strength: must be from 0 to 1, was 1.5"},
            {"start", "1e400", "start: must be above 0 and at most 1e50, was 1e400"},
            {"steps", "0.5", "steps: must be a whole number, was 0.5"},
            {"steps", "1e20", "steps: must be a whole number from 1 to 9, was 1e20"}
        };
        for (String[] mistake : mistakes) {
            String text = "{\"" + mistake[0] + "\": " + mistake[1] + "}";
            assertThatThrownBy(() -> inFile(text)).hasMessage("f:1:" + (mistake[0].length() + 6) + ": " + mistake[2]);
            assertThatThrownBy(() -> set(mistake[0], mistake[1])).hasMessage("--set: " + mistake[2]);
        }
        assertThatThrownBy(() -> set("strenght", "1"))
                .hasMessage("--set: unknown key \"strenght\"; allowed are strength, start, steps; did you mean"
                        + " \"strength\"?");
    }

    @Test
    void animationsFindIt() {
        StudioNumber number = StudioNumber.at("strength", Vignetting.DEFAULT);
        assertThat(number.in(Vignetting.DEFAULT)).isZero();
        assertThat(number.path().with(Vignetting.DEFAULT, 0.5)).isEqualTo(new Vignetting(0.5, 1, 3));
        assertThatThrownBy(() -> number.path().with(Vignetting.DEFAULT, 2.0))
                .hasMessage("strength must be from 0 to 1, was 2");
        assertThatThrownBy(() -> StudioNumber.at("end", Vignetting.DEFAULT))
                .hasMessage("number must be the path of a number (the scene has strength, start, steps), was end");
    }

    @Test
    void formsShowItWithItsMeaning() {
        List<Object> committed = new ArrayList<>();
        RecordForm form = new RecordForm(Vignetting.class, component -> true, committed::add);
        form.show(Vignetting.DEFAULT);
        Container panel = (Container) form.component();

        Components.enter(panel, "Strength", "0.25");
        Components.enter(panel, "Start", "-1");

        assertThat(committed).containsExactly(new Vignetting(0.25, 1, 3));
        assertThat(Components.labels(panel)).contains("Strength", "Start", "Steps");
        assertThat(Components.notes(panel))
                .anyMatch(note -> note.endsWith("Start must be above 0 and at most 1e50, was -1"));
        assertThat(Components.find(panel, JTextField.class, "Start").getToolTipText())
                .contains("Distance from the middle at which it begins");
    }

    @Test
    void theReferenceTellsOfIt() {
        assertThat(TypeReference.keysOf(Vignetting.class))
                .extracting(TypeReference.Key::unit, TypeReference.Key::allowed, TypeReference.Key::standard)
                .containsExactly(
                        tuple("", "from 0 to 1", "0"),
                        tuple("length", "above 0 and at most 1e50", "1"),
                        tuple("", "a whole number from 1 to 9", "3"));
    }
}
