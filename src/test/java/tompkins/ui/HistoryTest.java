package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.ui.picture.PictureCanvas;
import tompkins.ui.widget.ProseArea;
import tompkins.ui.widget.Texts;

/** What undo and reset do to values that were typed and not taken. */
class HistoryTest extends WindowFixture {

    @BeforeEach
    void open() {
        driver = new WindowDriver(folder, Studios.sphere(), null, List.of());
    }

    private JTextField field(String name) {
        return driver.find(JTextField.class, name);
    }

    private void undo() {
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    }

    private void redo() {
        driver.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    }

    @Test
    void aRefusedValueIsTakenBackAndNothingElse() {
        driver.type(field("Speed"), "0.5");
        Studio fast = driver.studio();
        driver.type(field("Aperture"), "1e400");
        assertThat(Components.isMarked(field("Aperture"))).isTrue();
        JTextField refused = field("Aperture");
        driver.click(field("Aperture"));
        undo();
        await("the end of the refused value", () -> !Components.isMarked(refused));
        assertThat(field("Aperture").getText()).isEqualTo("0");
        assertThat(driver.studio()).isSameAs(fast);
        undo();
        assertThat(driver.studio()).isEqualTo(Studios.sphere());
    }

    /** What is no part of the scene is no step, either. */
    @Test
    void undoingInTheAnimationLeavesTheSceneAlone() {
        driver.type(field("Speed"), "0.5");
        driver.menu("menu.playPanel");
        JTextField to = field("To");
        await("the panel", to::isShowing);
        String before = to.getText();
        driver.typeWithoutEnter(to, "0.7");
        undo();
        assertThat(driver.studio().velocity().speed()).isEqualTo(0.5);
        assertThat(to.getText()).isEqualTo(before).isNotEqualTo("0.7");
    }

    @Test
    void keysUndoWhatIsTypedThenTheStepBefore() {
        driver.type(field("Speed"), "0.5");
        driver.menu("menu.editScene");
        await("the editor", () -> driver.showing(ProseArea.class).findAny().isPresent());
        ProseArea remarks = driver.find(ProseArea.class, "Remarks");
        driver.typeWithoutEnter(remarks, "12 3");
        undo();
        assertThat(remarks.getText()).isEqualTo("12 ");
        undo();
        assertThat(remarks.getText()).isEqualTo("12");
        driver.key(KeyEvent.VK_Y, KeyEvent.VK_CONTROL);
        driver.key(KeyEvent.VK_6);
        assertThat(remarks.getText()).isEqualTo("12 6");
        driver.key(KeyEvent.VK_ENTER, KeyEvent.VK_CONTROL);
        assertThat(driver.studio().remarks()).isEqualTo("12 6");

        undo();
        assertThat(driver.studio().remarks()).as("what was taken is one step").isEmpty();
        assertThat(remarks.getText()).isEmpty();
        undo();
        assertThat(driver.studio()).isEqualTo(Studios.sphere());
    }

    /** Each tick of the animation would begin a new step otherwise. */
    @Test
    void undoingWhilePlayingPausesAndGoesBackToWhereItBegan() {
        driver.menu("menu.playSpeed");
        await("another speed", () -> !driver.studio().equals(Studios.sphere()));
        undo();
        assertThat(driver.studio()).isEqualTo(Studios.sphere());
        redo();
        Studio later = driver.studio();
        assertThat(later).isNotEqualTo(Studios.sphere());
        undo();
        assertThat(driver.studio()).isEqualTo(Studios.sphere());
    }

    /** What is folded away is neither lost nor in the way for ever. */
    @Test
    void aRefusedValueThatIsFoldedAwayIsTakenBackToo() {
        JTextField refused = field("Aperture");
        driver.type(refused, "1e400");
        driver.click(driver.find(JToggleButton.class, Texts.get("panel.all")));
        undo();
        assertThat(Components.isMarked(refused)).isFalse();
        assertThat(driver.studio()).isEqualTo(Studios.sphere());
    }

    @Test
    void resettingTakesBackRefusedValuesToo() {
        driver.type(field("Speed"), "0.5");
        driver.type(field("Aperture"), "-1");
        driver.type(field("Field of view (\u00b0)"), "1000");
        assertThat(Components.isMarked(field("Aperture"))).isTrue();
        driver.key(KeyEvent.VK_R, KeyEvent.VK_CONTROL);
        assertThat(Components.isMarked(field("Aperture"))).isFalse();
        assertThat(Components.isMarked(field("Field of view (\u00b0)"))).isFalse();
        assertThat(driver.studio()).isEqualTo(Studios.sphere());
    }

    /** Russian, where others have Z; and A, in a field. */
    @Test
    void theKeysWorkOnKeyboardsOfOtherScripts() {
        driver.type(field("Speed"), "0.5");
        driver.click(driver.find(PictureCanvas.class, "picture"));
        driver.keyWithCtrl('\u044f');
        assertThat(driver.studio()).isEqualTo(Studios.sphere());

        JTextField speed = field("Speed");
        driver.type(speed, "0.25");
        driver.click(speed);
        onEventThread(() -> speed.select(0, 0));
        driver.keyWithCtrl('\u0444');
        assertThat(speed.getSelectedText()).isEqualTo("0.25");
    }

    @Test
    void aStepToAnotherSceneIsSpokenOf() {
        driver.type(field("Speed"), "0.5");
        driver.key(KeyEvent.VK_N, KeyEvent.VK_CONTROL);
        await("the form", () -> driver.window().side.isEditing());
        driver.key(KeyEvent.VK_E, KeyEvent.VK_CONTROL);
        await("the few controls", () -> !driver.window().side.isEditing());
        Studio begun = driver.studio();
        driver.type(field("Speed"), "0.7");
        undo();
        assertThat(driver.studio()).isEqualTo(begun);
        await("a hint", () -> driver.said().startsWith("A scene without objects"));
        undo();
        String title = Studios.sphere().title();
        assertThat(driver.studio().title()).isEqualTo(title);
        assertThat(driver.said()).isEqualTo("Back in another scene: \u201c" + title + "\u201d.");
        redo();
        assertThat(driver.said()).isEqualTo("Back in another scene: \u201c" + begun.title() + "\u201d.");
    }
}
