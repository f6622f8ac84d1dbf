package tompkins.ui.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.awt.Container;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import javax.accessibility.AccessibleValue;
import javax.swing.JComboBox;
import javax.swing.JSlider;
import javax.swing.JTextField;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.FocusDistance;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.ThinLensCamera;
import tompkins.lesson.Lesson;
import tompkins.light.ColourLaw;
import tompkins.property.Descriptions;
import tompkins.ray.MeshData;
import tompkins.ray.MeshDetail;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.TriangleMesh;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LorentzWindow;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;
import tompkins.ui.Components;
import tompkins.ui.LightLook;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.compare.Compared;
import tompkins.ui.model.Shutters;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.SceneSize;
import tompkins.ui.picture.Comparison;
import tompkins.ui.widget.Texts;

@LightLook
class PanelsTest {

    private final StudioModel model = new StudioModel(Studios.lattice(), null);
    private Compared compared = Compared.NOTHING;

    private Velocity velocity() {
        return model.studio().velocity();
    }

    /** Half of the slider is half of its rapidity: artanh(0.995) / 2 = 1.4967, and tanh(1.4967) = 0.9048. */
    @Test
    void theSliderStepsInRapidityAndIsExactAtRest() {
        Container panel = (Container) new ControlRows(model).component();
        JSlider slider = Components.find(panel, JSlider.class, "Speed, slider");
        slider.setValue(500);
        assertThat(velocity().speed()).isEqualTo(0.905);
        slider.setValue(1000);
        assertThat(velocity().speed()).isEqualTo(0.995);
        slider.setValue(0);
        assertThat(velocity().isRest()).isTrue();
        slider.setValue(500);
        assertThat(velocity().given())
                .as("the direction is not forgotten at rest")
                .isEqualTo(new Vector3d(0.1, 0, 0.99));
    }

    @Test
    void anotherNotationShowsTheSameSpeed() {
        model.set(model.studio().withVelocity(Velocity.of(SpeedScale.GAMMA, 10, new Vector3d(0, 0, 1))));
        Container panel = (Container) new ControlRows(model).component();
        Components.find(panel, JComboBox.class, Texts.get("speed.scale")).setSelectedItem(SpeedScale.GAMMA);
        JTextField speed = Components.find(panel, JTextField.class, "Speed");
        assertThat(speed.getText()).isEqualTo("10");
        Components.enter(panel, "Speed", "20");
        assertThat(velocity().gamma()).isEqualTo(20);
        Components.enter(panel, "Speed", "0.5c");
        assertThat(Components.isMarked(speed))
                .as("a plain number is a gamma here")
                .isTrue();
        Components.enter(panel, "Speed", "150000 km/s");
        assertThat(velocity().speed()).isCloseTo(150_000 / 299_792.458, within(1e-12));
    }

    /** A step of the slider is a thousandth of its rapidity. */
    @Test
    void aScreenReaderHearsAndSetsTheSpeed() {
        model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.5)));
        Container panel = (Container) new ControlRows(model).component();
        AccessibleValue slider = Components.find(panel, JSlider.class, "Speed, slider")
                .getAccessibleContext()
                .getAccessibleValue();
        assertThat(slider.getCurrentAccessibleValue().doubleValue()).isCloseTo(0.5, within(0.003));
        assertThat(slider.getMaximumAccessibleValue()).isEqualTo(0.995);
        slider.setCurrentAccessibleValue(0.9);
        assertThat(velocity().speed()).isCloseTo(0.9, within(1e-3));
    }

    @ParameterizedTest
    @CsvSource({
        "Aperture, -1",
        "Field of view (\u00b0), 1000",
        "Exposure, 1e400",
        "Opening time, 1e400",
        "Opening time, soon"
    })
    void aRefusalSpeaksOfTheFieldByItsLabel(String label, String wrong) {
        Container panel = (Container) new ControlRows(model).component();
        Studio before = model.studio();
        assertThat(Components.isMarked(Components.enter(panel, label, wrong))).isTrue();
        assertThat(Components.notes(panel)).anyMatch(text -> text.startsWith("\u26a0 " + label + " must be "));
        assertThat(model.studio()).isSameAs(before);
    }

    @Test
    void anotherShutterOpensSoThatTheMiddleKeepsItsTime() {
        Container panel = (Container) new ControlRows(model).component();
        JComboBox<?> models = Components.find(panel, JComboBox.class, "Shutter");
        models.setSelectedItem(FocusSurfaceShutter.class);
        // light from the focus at distance 10 crosses the lens at time 0
        assertThat(model.studio().camera().shutter()).isEqualTo(new FocusSurfaceShutter(-10));
        models.setSelectedItem(DetectorPlaneShutter.class);
        assertThat(model.studio().camera().shutter()).isEqualTo(new DetectorPlaneShutter(1, 1));
        Components.enter(panel, "Opening time", "2");
        models.setSelectedItem(AperturePlaneShutter.class);
        assertThat(model.studio().camera().shutter().openingTime()).isCloseTo(1, within(1e-9));
        JTextField time = Components.find(panel, JTextField.class, "Opening time");
        assertThat(time.getParent().isVisible()).isTrue();
        models.setSelectedItem(FixedPointSurfaceShutter.class);
        assertThat(time.getParent().isVisible()).as("it has none").isFalse();
    }

    @Test
    void aPanoramaHasNoAperture() {
        Container panel = (Container) new ControlRows(model).component();
        JTextField aperture = Components.enter(panel, "Aperture", "0.25");
        assertThat(((ThinLensCamera) model.studio().camera()).apertureRadius()).isEqualTo(0.25);
        model.set(model.studio().withCamera(PanoramicCamera.DEFAULT));
        assertThat(aperture.getParent().isVisible()).isFalse();
    }

    @Test
    void coloursAndViewAreChosen() {
        Container panel = (Container) new ControlRows(model).component();
        Studio before = model.studio();
        Components.find(panel, JComboBox.class, "Colours").setSelectedItem(ColourLaw.DOPPLER);
        assertThat(model.studio()).isEqualTo(before.withColours(ColourLaw.DOPPLER));
        JComboBox<?> view = Components.find(panel, JComboBox.class, "View");
        view.setSelectedItem(View.MEASURED);
        assertThat(model.studio().view()).isEqualTo(View.MEASURED);
        model.set(before);
        assertThat(view.getSelectedItem()).isEqualTo(View.SEEN);
    }

    /** A hand that only touches the knob changes nothing, though the slider cannot show all digits. */
    @Test
    void pressingAKnobChangesNothing() {
        model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.9876543)));
        Studio before = model.studio();
        Container panel = (Container) new ControlRows(model).component();
        JSlider slider = Components.find(panel, JSlider.class, "Speed, slider");
        slider.setValueIsAdjusting(true);
        slider.setValueIsAdjusting(false);
        assertThat(model.studio()).isSameAs(before);
        slider.setValueIsAdjusting(true);
        slider.setValue(slider.getValue() + 1);
        assertThat(velocity().speed()).isGreaterThan(0.9876543);
    }

    /** A ball stays as round as it is: the tangents of half the angles keep their ratio. */
    @Test
    void aWiderFieldOfViewKeepsTheProportions() {
        Container panel = (Container) new ControlRows(model).component();
        ThinLensCamera camera = Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", 90.0);
        model.set(model.studio().withCamera(Descriptions.with(camera, "verticalAngleDegrees", 60.0)));
        Components.enter(panel, "Field of view (\u00b0)", "120");
        ThinLensCamera wider = (ThinLensCamera) model.studio().camera();
        assertThat(wider.horizontalAngleDegrees()).isEqualTo(120);
        // tan 45 : tan 30 = tan 60 : 1
        assertThat(wider.verticalAngleDegrees()).isCloseTo(90, within(1e-9));
        Components.enter(panel, "Field of view (\u00b0)", "90");
        assertThat(model.studio().camera()).isEqualTo(Descriptions.with(camera, "verticalAngleDegrees", 60.0));

        model.set(model.studio().withCamera(PanoramicCamera.DEFAULT));
        Components.enter(panel, "Field of view (\u00b0)", "90");
        assertThat(((PanoramicCamera) model.studio().camera()).verticalAngleDegrees())
                .isEqualTo(45);
    }

    @Test
    void aSpeedOfNewtonsWorldHasNoLorentzFactor() {
        Container panel = (Container) new ControlRows(model).component();
        model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.6)));
        assertThat(Components.notes(panel))
                .containsExactly(
                        "Lorentz factor \u03b3\u00a0=\u00a01.25, rapidity\u00a0\u03b7\u00a0=\u00a00.6931\nVelocity \u03b2 = (0, 0, 0.6)");
        model.set(model.studio().withTransformation(TransformationLaw.GALILEAN));
        assertThat(Components.notes(panel)).containsExactly("Velocity \u03b2 = (0, 0, 0.6)");
        model.set(model.studio().withTransformation(TransformationLaw.NONE));
        assertThat(Components.notes(panel))
                .containsExactly("Velocity \u03b2 = (0, 0, 0.6), ignored: the transformation is \u201cNone\u201d");
    }

    @Test
    void aSpeedOfLightIsMarked() {
        Container panel = (Container) new ControlRows(model).component();
        Velocity before = velocity();
        JTextField speed = Components.enter(panel, "Speed", "1");
        assertThat(Components.isMarked(speed)).isTrue();
        assertThat(velocity()).isSameAs(before);
        model.set(model.studio().withTransformation(TransformationLaw.GALILEAN));
        assertThat(speed.getText())
                .as("the wrong entry stays until it is put right")
                .isEqualTo("1");
        model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.5)));
        assertThat(Components.isMarked(speed)).as("another value came").isFalse();
    }

    @Test
    void aSpeedBeyondTheGuaranteeWarns() {
        Container panel = (Container) new ControlRows(model).component();
        Components.enter(panel, "Speed", "gamma 1e6");
        assertThat(Components.notes(panel)).noneMatch(text -> text.contains("may be wrong"));
        Components.enter(panel, "Speed", "gamma 1e7");
        assertThat(Components.notes(panel)).anyMatch(text -> text.contains("gamma 10000000 is above 1000000"));
        model.set(model.studio().withTransformation(TransformationLaw.GALILEAN));
        assertThat(Components.notes(panel)).noneMatch(text -> text.contains("gamma"));
    }

    /**
     * Light in the middle reaches a detector at distance 1 at time 1, wherever the focus is. Light from the focus
     * crosses the lens at time 0; of a focus behind the camera that is the time in advance.
     */
    @ParameterizedTest
    @ValueSource(doubles = {10, -5})
    void anotherShutterOpensForTheLightOfTheMiddle(double focus) {
        assertThat(opened(DetectorPlaneShutter.class, focus)).isEqualTo(new DetectorPlaneShutter(1, 1));
        assertThat(opened(FocusSurfaceShutter.class, focus)).isEqualTo(new FocusSurfaceShutter(-focus));
    }

    /** A shutter model in the place of that of the studio, with the camera focused at a distance. */
    private Shutter opened(Class<?> shutter, double focus) {
        Studio focused =
                model.studio().withCamera(FocusDistance.with(model.studio().camera(), focus));
        return Shutters.replaced(focused, shutter).camera().shutter();
    }

    @Test
    void timesReachThroughTheScene() {
        assertThat(new SceneSize().times(model.studio()).minimum()).isEqualTo(-20);
        double[] coordinates = {0, 0, 10, 30, -45, 10, 0, 40, 10};
        MeshData triangle = new MeshData("", coordinates, new int[] {0, 1, 2}, MeshDetail.NONE, new byte[0]);
        Studio large = model.studio()
                .withScene(List.of(new TriangleMesh("", triangle, ColouredSurface.DEFAULT, true), Sphere.DEFAULT));
        // 1.2 times 45, upwards
        assertThat(new SceneSize().times(large).maximum()).isEqualTo(100);
    }

    /** A change of the speed makes nothing for each object: the size of the scene, for one, is looked up once. */
    @Test
    void scenesWithManyObjectsDoNotSlowTheSlidersDown() {
        bytesOfADrag(20);
        assertThat(bytesOfADrag(20_000))
                .as("bytes, of 1000 times as many objects")
                .isLessThan(2 * bytesOfADrag(20));
    }

    /** The memory that a drag of the speed takes, before the panels, in a scene with so many objects. */
    private static long bytesOfADrag(int objects) {
        StudioModel scene = new StudioModel(Studio.DEFAULT, null);
        new ControlRows(scene);
        List<SceneObject> many = new ArrayList<>();
        for (int i = 0; i < objects; i++) {
            many.add(new Sphere("", new Vector3d(i, 0, 10), 0.1, ColouredSurface.DEFAULT));
        }
        scene.open(scene.studio().withScene(many), null);
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = thread.getCurrentThreadAllocatedBytes();
        for (int i = 1; i <= 11; i++) {
            scene.adjust(scene.studio().withVelocity(Velocity.of(0, 0, i / 20.0)), "drag");
        }
        return thread.getCurrentThreadAllocatedBytes() - before;
    }

    /** The ball passes a camera at rest: at another time it is elsewhere. */
    @Test
    void theOpeningTimeIsOfferedWhereOnlyTheSceneMoves() {
        Moving far = Descriptions.with(Moving.DEFAULT, "place", new Vector3d(-40, 0, 0));
        Studio studio = Studios.lattice().withVelocity(Velocity.REST).withScene(List.of(far));
        model.set(studio);
        assertThat(RenderPlan.of(studio).isStill()).isFalse();
        Container panel = (Container) new ControlRows(model).component();
        JTextField time = Components.find(panel, JTextField.class, "Opening time");
        assertThat(time.getParent().isVisible()).isTrue();
        // it passes the middle at time 80, its light comes 10 later
        Components.enter(panel, "Opening time", "89");
        assertThat(model.studio().camera().shutter().openingTime()).isEqualTo(89);
        SampleHistory before = SampleHistory.of(RenderPlan.of(studio), 320, 240, 0, 0);
        SampleHistory now = SampleHistory.of(RenderPlan.of(model.studio()), 320, 240, 0, 0);
        assertThat(before.end()).isNull();
        assertThat(now.end().object().description()).isEqualTo("sphere");
        assertThat(new SceneSize().times(studio).maximum()).isGreaterThanOrEqualTo(40);
    }

    @Test
    void comparisonsDifferInOneThing() {
        ComparePanel panel = comparePanel();
        Studio now = model.studio();
        assertThat(compared.studio(now)).isNull();
        assertThat(compared.view()).isEqualTo(Comparison.NONE);
        compareWith(panel, ComparePanel.Other.AT_REST);
        assertThat(compared.studio(now)).isEqualTo(now.withVelocity(Velocity.REST));
        LorentzWindow matching = Descriptions.with(LorentzWindow.DEFAULT, "velocity", now.velocity());
        assertThat(FrontWindow.matches(compared.studio(FrontWindow.with(now, matching))))
                .as("a camera at rest sees through its window what is there")
                .isTrue();
        compareWith(panel, ComparePanel.Other.GALILEAN_CAMERA);
        assertThat(compared.studio(now)).isEqualTo(now.withTransformation(TransformationLaw.GALILEAN));
        compareWith(panel, ComparePanel.Other.MEASURED);
        assertThat(compared.studio(now)).isEqualTo(now.withView(View.MEASURED));
        assertThat(compared.name()).contains("not a photo");
        compareWith(panel, ComparePanel.Other.SEEN);
        assertThat(compared.studio(now.withView(View.MEASURED))).isEqualTo(now);
        compareWith(panel, ComparePanel.Other.UNCHANGED_COLOURS);
        assertThat(compared.studio(now.withColours(ColourLaw.DOPPLER))).isEqualTo(now);
        Components.find((Container) panel.component(), JComboBox.class, "Shutter to compare with")
                .setSelectedItem(FocusSurfaceShutter.class);
        compareWith(panel, ComparePanel.Other.OTHER_SHUTTER);
        assertThat(compared.studio(now))
                .isEqualTo(now.withCamera(now.camera().withShutter(new FocusSurfaceShutter(-10))));
        assertThat(compared.view()).isEqualTo(Comparison.SPLIT);
        Components.find((Container) panel.component(), JComboBox.class, "Both pictures")
                .setSelectedItem(Comparison.DIFFERENCE);
        assertThat(compared.view()).isEqualTo(Comparison.DIFFERENCE);
    }

    private static void compareWith(ComparePanel panel, ComparePanel.Other other) {
        Components.find((Container) panel.component(), JComboBox.class, "Compare with")
                .setSelectedItem(other);
    }

    private ComparePanel comparePanel() {
        return new ComparePanel(model, next -> compared = next, () -> "kept");
    }

    @Test
    void thePictureOnShowIsKept() {
        ComparePanel panel = comparePanel();
        compareWith(panel, ComparePanel.Other.KEPT_PICTURE);
        assertThat(compared.name()).isEqualTo("kept");
        assertThat(compared.view()).isEqualTo(Comparison.SPLIT);
    }

    @ParameterizedTest
    @ValueSource(classes = {AperturePlaneShutter.class, DetectorPlaneShutter.class, FixedPointSurfaceShutter.class})
    void theOtherShutterIsAnotherOne(Class<?> shutter) {
        Studio now = Shutters.replaced(model.studio(), shutter);
        model.set(now);
        ComparePanel panel = comparePanel();
        JComboBox<?> shutters =
                Components.find((Container) panel.component(), JComboBox.class, "Shutter to compare with");
        shutters.setSelectedItem(shutter);
        compareWith(panel, ComparePanel.Other.OTHER_SHUTTER);
        assertThat(shutters.getSelectedItem()).isNotEqualTo(shutter);
        assertThat(compared.studio(now).camera().shutter().getClass()).isEqualTo(shutters.getSelectedItem());
        shutters.setSelectedItem(shutter);
        assertThat(compared.studio(now).camera().shutter())
                .as("who wants the same may have it")
                .isInstanceOf(shutter);
    }

    /** Nobody asked for it; what somebody chose stays. */
    @Test
    void theComparisonOfTheFirstSceneEndsWithIt() {
        ComparePanel panel = comparePanel();
        panel.begin(ComparePanel.Other.AT_REST);
        model.set(model.studio().withVelocity(Velocity.REST));
        assertThat(compared.view()).isEqualTo(Comparison.SPLIT);
        model.open(Studios.sphere(), null);
        assertThat(compared.view()).isEqualTo(Comparison.NONE);
        panel.begin(ComparePanel.Other.AT_REST);
        compareWith(panel, ComparePanel.Other.GALILEAN_CAMERA);
        model.open(Studios.lattice(), null);
        assertThat(compared.view()).isEqualTo(Comparison.SPLIT);
    }

    @Test
    void aLessonBeginsWithoutComparison() {
        ComparePanel panel = comparePanel();
        compareWith(panel, ComparePanel.Other.AT_REST);
        model.open(Studios.sphere(), null);
        assertThat(compared.view()).as("as it was chosen").isEqualTo(Comparison.SPLIT);
        model.open(Descriptions.with(Studios.sphere(), "lesson", Lesson.DEFAULT), null);
        assertThat(compared.view()).isEqualTo(Comparison.NONE);
        compareWith(panel, ComparePanel.Other.AT_REST);
        model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.25)));
        assertThat(compared.view()).as("while the lesson goes on").isEqualTo(Comparison.SPLIT);
    }
}
