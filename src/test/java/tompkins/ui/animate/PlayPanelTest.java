package tompkins.ui.animate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JSlider;
import javax.swing.JTextField;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.animation.Animation;
import tompkins.camera.FocusDistance;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.ThinLensCamera;
import tompkins.explain.Flashes;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.Studios;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LorentzWindow;
import tompkins.trace.RenderPlan;
import tompkins.ui.Components;
import tompkins.ui.LightLook;
import tompkins.ui.WindowDriver;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.widget.Texts;

@LightLook
class PlayPanelTest {

    private static final String SPEED = "Speed beta in units of c";
    private static final String OPENING_TIME = "Opening time of the shutter";

    private final StudioModel model = new StudioModel(Studios.sphere(), null);
    private final List<Animation> exported = new ArrayList<>();
    private final List<NumberProperty> told = new ArrayList<>();
    private final PlayPanel play = new PlayPanel(model, (studio, animation) -> exported.add(animation), told::add);
    private final Container panel = (Container) play.component();
    private final JComboBox<?> numbers = Components.find(panel, JComboBox.class, "Value to animate");

    @BeforeEach
    void show() {
        play.setShown(true);
    }

    @AfterEach
    void stop() {
        play.setPlaying(false);
    }

    @Test
    void hiddenItPauses() {
        WindowDriver.onEventThread(() -> {
            play.setPlaying(true);
            play.setShown(false);
            assertThat(play.component().isVisible()).isFalse();
            assertThat(play.isPlaying()).isFalse();
            assertThat(told).last().isNull();
        });
    }

    private List<String> offered() {
        return IntStream.range(0, numbers.getItemCount())
                .mapToObj(numbers::getItemAt)
                .map(Object::toString)
                .toList();
    }

    private String chosen() {
        return numbers.getSelectedItem().toString();
    }

    private void choose(String name) {
        numbers.setSelectedIndex(offered().indexOf(name));
        assertThat(chosen()).isEqualTo(name);
    }

    private void scrub(int place) {
        Components.find(panel, JSlider.class, "Time").setValue(place);
    }

    @Test
    void tellsWhichNumberIsAnimatedWhileItIsShown() {
        choose(OPENING_TIME);
        assertThat(told.get(told.size() - 1)).isEqualTo(NumberProperty.openingTime());
        play.setShown(false);
        assertThat(told.get(told.size() - 1)).isNull();
        play.setShown(true);
        assertThat(told.get(told.size() - 1)).isEqualTo(NumberProperty.openingTime());
    }

    @Test
    void anAnimationThatIsSavedPauses() {
        WindowDriver.onEventThread(() -> {
            play.setPlaying(true);
            Components.find(panel, JButton.class, Texts.get("play.export")).doClick();
            assertThat(play.isPlaying()).isFalse();
        });
        assertThat(exported).hasSize(1);
    }

    @Test
    void nothingRunsWithAValueThatWasRefused() {
        choose(SPEED);
        Components.enter(panel, "To", "1");
        WindowDriver.onEventThread(() -> {
            play.setPlaying(true);
            assertThat(play.isPlaying()).isFalse();
        });
        JButton export = Components.find(panel, JButton.class, Texts.get("play.export"));
        export.doClick();
        assertThat(exported).isEmpty();
        assertThat(Components.notes(panel)).anyMatch(text -> text.startsWith("\u26a0"));
        // typed, but not yet entered
        Components.find(panel, JTextField.class, "To").setText("0.9");
        export.doClick();
        assertThat(exported).singleElement().extracting(Animation::to).isEqualTo(0.9);
        WindowDriver.onEventThread(() -> {
            play.setPlaying(true);
            assertThat(play.isPlaying()).isTrue();
        });
    }

    @ParameterizedTest
    @CsvSource({"FORWARDS, 250", "BACKWARDS, 750", "THERE_AND_BACK, 125"})
    void theScrubberStandsAtTheNumberOfTheScene(Animation.Course course, int place) {
        choose(SPEED);
        Components.find(panel, JComboBox.class, "Direction").setSelectedItem(course);
        Components.enter(panel, "To", "0.8");
        model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.2)));
        assertThat(place()).isEqualTo(place);
        Components.enter(panel, "To", "0.2");
        Components.enter(panel, "From", "0.2");
        Components.enter(panel, "To", "0.8");
        Components.enter(panel, "From", "0");
        assertThat(place()).as("after other ends").isEqualTo(place);
    }

    @Test
    void theScrubberStaysWhereItWasDraggedOnTheWayBack() {
        choose(SPEED);
        Components.find(panel, JComboBox.class, "Direction").setSelectedItem(Animation.Course.THERE_AND_BACK);
        scrub(800);
        assertThat(place()).isEqualTo(800);
        model.set(model.studio().withCamera(PanoramicCamera.DEFAULT));
        assertThat(place()).isEqualTo(800);
    }

    @Test
    void aSpeedNearThatOfLightIsShownAsInItsField() {
        choose(SPEED);
        model.set(model.studio().withVelocity(Velocity.of(SpeedScale.ONE_MINUS_BETA, 5e-15, new Vector3d(0, 0, 1))));
        assertThat(Components.labels(panel)).contains("1-5e-15");
        assertThat(place()).isEqualTo(1000);
    }

    private int place() {
        return Components.find(panel, JSlider.class, "Time").getValue();
    }

    private static SceneObject ball(String name) {
        return new Sphere(name, new Vector3d(0, 0, 5), 1, ColouredSurface.DEFAULT);
    }

    private static Studio with(SceneObject... objects) {
        return Studios.sphere().withScene(List.of(objects));
    }

    private double radius(int index) {
        return ((Sphere) model.studio().scene().get(index)).radius();
    }

    @Test
    void aNumberThatAnotherSceneLacksRunsNoMore() {
        WindowDriver.onEventThread(() -> {
            model.open(with(ball("red"), ball("green")), null);
            choose("Scene \u203a green \u203a Radius");
            play.setPlaying(true);

            model.open(with(ball("blue"), ball("white")), null);

            assertThat(offered())
                    .contains("Scene \u203a white \u203a Radius")
                    .noneMatch(name -> name.contains("red") || name.contains("green"));
            assertThat(chosen()).isEqualTo(SPEED);
            assertThat(play.isPlaying()).isFalse();
            scrub(1000);
            assertThat(model.studio().velocity().speed()).isEqualTo(0.99);
            assertThat(model.studio().scene()).isEqualTo(List.of(ball("blue"), ball("white")));
        });
    }

    @Test
    void aNumberThatBothScenesHaveRunsOn() {
        WindowDriver.onEventThread(() -> {
            choose("Camera \u203a Exposure");
            Components.enter(panel, "To", "3");
            play.setPlaying(true);

            model.open(with(ball("red")), null);

            assertThat(chosen()).isEqualTo("Camera \u203a Exposure");
            assertThat(play.isPlaying()).isTrue();
            assertThat(Components.find(panel, JTextField.class, "To").getText()).isEqualTo("3");
            scrub(1000);
            assertThat(model.studio().camera().exposureStops()).isEqualTo(3);
        });
    }

    @Test
    void anotherObjectOfTheSameNameIsAnotherNumber() {
        model.open(with(ball("red"), ball("ball"), ball("ball")), null);
        numbers.setSelectedIndex(offered().lastIndexOf("Scene \u203a ball \u203a Radius"));

        scrub(1000);
        assertThat(List.of(radius(0), radius(1), radius(2))).containsExactly(1.0, 1.0, 2.0);

        model.set(with(ball("ball"), ball("ball")));
        assertThat(chosen()).isEqualTo(SPEED);
    }

    @Test
    void camerasAndShuttersBringTheirOwnNumbers() {
        Studio studio = model.studio();
        model.set(studio.withCamera(studio.camera().withShutter(DetectorPlaneShutter.DEFAULT)));
        assertThat(offered()).contains("Camera \u203a Shutter \u203a Detector distance");
        model.set(studio.withCamera(PanoramicCamera.DEFAULT));
        assertThat(offered())
                .contains("Camera \u203a Focus")
                .doesNotContain("Camera \u203a Aperture", "Camera \u203a Shutter \u203a Detector distance");
    }

    @Test
    void aShutterWithoutOpeningTimeHasNoneToRun() {
        choose(OPENING_TIME);
        Shutter fixed = FixedPointSurfaceShutter.DEFAULT;
        model.set(model.studio().withCamera(model.studio().camera().withShutter(fixed)));
        assertThat(chosen()).isEqualTo(SPEED);
        play.run(NumberProperty.openingTime());
        assertThat(play.isPlaying()).isFalse();
        assertThat(Components.notes(panel)).anyMatch(text -> text.startsWith("\u26a0 " + OPENING_TIME));
    }

    /** Also those that cannot be twice as large, such as the angle of a camera or the speed of a window. */
    @Test
    void whatIsSuggestedIsAllowed() {
        Studio studio = model.studio();
        ThinLensCamera wide = Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", 120.0);
        model.set(FrontWindow.with(studio.withCamera(wide), LorentzWindow.DEFAULT));
        assertThat(offered()).anyMatch(name -> name.endsWith("Velocity"));
        for (int i = 0; i < numbers.getItemCount(); i++) {
            numbers.setSelectedIndex(i);
            StudioNumber number = ((NumberProperty) numbers.getSelectedItem()).number();
            double from = end("From");
            double to = end("To");
            assertThat(to).as(chosen()).isNotEqualTo(from);
            assertThat(number.in(number.with(model.studio(), from))).isEqualTo(from);
            assertThat(number.in(number.with(model.studio(), to))).isEqualTo(to);
        }
    }

    private double end(String name) {
        return Double.parseDouble(Components.find(panel, JTextField.class, name).getText());
    }

    /** The list is that of the scene, also after the panel was hidden. */
    @Test
    void aHiddenPanelCatchesUpWhenItIsShown() {
        WindowDriver.onEventThread(() -> {
            play.setShown(false);
            model.open(with(ball("red")), null);
            play.run(NumberProperty.speed(SpeedScale.BETA));
            assertThat(play.isPlaying()).isTrue();
            assertThat(Stream.of("red", "sphere")
                            .filter(name -> offered().contains("Scene \u203a " + name + " \u203a Radius")))
                    .containsExactly("red");
        });
    }

    /** Or each step of the animation would take it out of the hand again. */
    @Test
    void whoeverSetsTheNumberThatRunsHasIt() {
        WindowDriver.onEventThread(() -> {
            choose(SPEED);
            play.setPlaying(true);

            model.set(
                    model.studio().withCamera(FocusDistance.with(model.studio().camera(), 7)));
            assertThat(play.isPlaying()).as("another number").isTrue();
            model.adjust(model.studio().withVelocity(Velocity.of(0, 0, 0.33)), "drag");

            assertThat(play.isPlaying()).isFalse();
            assertThat(model.studio().velocity().speed()).isEqualTo(0.33);
            assertThat(place()).isEqualTo(333);
        });
    }

    @Test
    void anotherNumberRunsOnFromWhereItIs() {
        WindowDriver.onEventThread(() -> {
            choose(SPEED);
            play.setPlaying(true);
            choose("Camera \u203a Exposure");
            assertThat(play.isPlaying()).isTrue();
        });
    }

    /** The lamp stands at the camera, and a wall 2 away is seen up to 45 degrees: light from 4 to 4 sqrt(2) or so. */
    @Test
    void lightTravelsWhileSomethingIsLit() {
        PointLight lamp = new PointLight(new Vector3d(), Colour.WHITE, Colour.WHITE, 1, new Pulse(0, 0.1, 0));
        SceneObject wall = new Plane("wall", new Vector3d(0, 0, 2), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT);
        Studio studio = Lighting.of(Studios.sphere().withScene(List.of(wall)), List.of(lamp));
        WindowDriver.onEventThread(() -> {
            model.set(studio);
            play.runLight(new Flashes(RenderPlan.of(studio)).litTimes());
            assertThat(chosen()).isEqualTo(OPENING_TIME);
            assertThat(play.isPlaying()).isTrue();
            Animation animation = play.wanted().orElseThrow();
            assertThat(animation.from()).isCloseTo(4, within(0.01));
            assertThat(animation.to()).isBetween(4.15, 6.0);
        });
    }

    @Test
    void withoutAFlashNoLightTravels() {
        WindowDriver.onEventThread(() -> {
            play.runLight(new Flashes(RenderPlan.of(model.studio())).litTimes());
            assertThat(play.isPlaying()).isFalse();
            assertThat(Components.notes(panel)).anyMatch(note -> note.endsWith(Texts.get("play.noFlash")));
        });
    }
}
