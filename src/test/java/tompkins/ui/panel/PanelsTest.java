package tompkins.ui.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Component;
import java.awt.Container;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.accessibility.AccessibleValue;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ProcessorTime;
import tompkins.camera.Camera;
import tompkins.camera.FocusDistance;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.Stereo;
import tompkins.camera.StereoLayout;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.lesson.Lesson;
import tompkins.light.ColourLaw;
import tompkins.light.Metering;
import tompkins.property.Descriptions;
import tompkins.ray.MeshData;
import tompkins.render.Quality;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.TriangleMesh;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.shutter.FocusSurfaceShutter;
import tompkins.shutter.RollingShutter;
import tompkins.shutter.Shutter;
import tompkins.shutter.SweepDirection;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.surface.GalileoWindow;
import tompkins.surface.LorentzWindow;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;
import tompkins.ui.Components;
import tompkins.ui.animate.PlayPanel;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.compare.Compared;
import tompkins.ui.model.Shutters;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.number.SceneSize;
import tompkins.ui.picture.Comparison;
import tompkins.ui.picture.Picture;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Range;
import tompkins.ui.widget.Texts;

/** The parts of the side panel, without a display. */
class PanelsTest {

    private final StudioModel model = new StudioModel(Studios.lattice(), null);
    private Compared compared = Compared.NOTHING;

    @BeforeAll
    static void look() {
        Look.LIGHT.install();
    }

    private Velocity velocity() {
        return model.studio().velocity();
    }

    @ParameterizedTest
    @CsvSource({"0.97, 0.97", "gamma 10, 0.994987437106620", "1-1e-9, 0.999999999", "rapidity 2, 0.964027580075817"})
    void typedSpeedsKeepTheDirection(String text, double beta) {
        Container panel = (Container) new VelocityPanel(model).component();
        Components.enter(panel, "Speed", text);
        assertThat(velocity().speed()).isCloseTo(beta, within(1e-15));
        assertThat(velocity().direction().angle(new Vector3d(0.1, 0, 0.99))).isCloseTo(0, within(1e-7));
    }

    @Test
    void theSliderStepsInRapidityAndIsExactAtRest() {
        Container panel = (Container) new VelocityPanel(model).component();
        JSlider slider = Components.find(panel, JSlider.class, "Speed, slider");
        slider.setValue(400);
        assertThat(velocity().rapidity()).isCloseTo(1.5, within(0.05));
        slider.setValue(800);
        assertThat(velocity().rapidity()).isCloseTo(3, within(0.05));
        slider.setValue(1000);
        assertThat(velocity().rapidity()).isCloseTo(6, within(0.05));
        slider.setValue(0);
        assertThat(velocity().isRest()).isTrue();
        slider.setValue(500);
        assertThat(velocity().given())
                .as("the direction is not forgotten at rest")
                .isEqualTo(new Vector3d(0.1, 0, 0.99));
    }

    /** A hand that only touches the knob changes nothing, though the slider cannot show all digits. */
    @Test
    void pressingAKnobChangesNothing() {
        model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.9876543)));
        Studio before = model.studio();
        Container panel = (Container) new VelocityPanel(model).component();
        JSlider slider = Components.find(panel, JSlider.class, "Speed, slider");
        slider.setValueIsAdjusting(true);
        slider.setValueIsAdjusting(false);
        assertThat(model.studio()).isSameAs(before);
        slider.setValueIsAdjusting(true);
        slider.setValue(slider.getValue() + 1);
        assertThat(velocity().speed()).isGreaterThan(0.9876543);
    }

    @Test
    void aShutterIsFoundByItsFirstLetterAndSpokenByItsName() {
        Container panel = shutter(new ShutterPanel(model));
        @SuppressWarnings("unchecked")
        JComboBox<Class<?>> models = Components.find(panel, JComboBox.class, "Shutter model");
        models.selectWithKeyChar('d');
        assertThat(model.studio().camera().shutter()).isInstanceOf(DetectorPlaneShutter.class);
        Component cell = models.getRenderer()
                .getListCellRendererComponent(new JList<>(), DetectorPlaneShutter.class, 0, false, false);
        assertThat(cell.getAccessibleContext().getAccessibleName()).isEqualTo("Detector plane shutter");
    }

    /** A ball stays as round as it is: the tangents of half the angles keep their ratio. */
    @Test
    void aWiderFieldOfViewKeepsTheProportions() {
        Container panel = (Container) new LensPanel(model, picking -> {}).component();
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
    void theSwitchShowsTheSameSpeedOnAnotherScale() {
        model.set(model.studio().withVelocity(Velocity.of(SpeedScale.GAMMA, 10, new Vector3d(0, 0, 1))));
        Container panel = (Container) new VelocityPanel(model).component();
        Components.find(panel, JToggleButton.class, "Lorentz factor gamma").doClick();
        JTextField speed = Components.find(panel, JTextField.class, "Speed");
        assertThat(speed.getText()).isEqualTo("10");
        Components.enter(panel, "Speed", "20");
        assertThat(velocity().gamma()).isEqualTo(20);
    }

    @Test
    void aSpeedOfNewtonsWorldHasNoLorentzFactor() {
        Container panel = (Container) new VelocityPanel(model).component();
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
        Container panel = (Container) new VelocityPanel(model).component();
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

    /** A scene with such a speed could not be opened again. */
    @Test
    void aSpeedWithoutPicturesIsMarkedWhereverItIsTyped() {
        model.set(FrontWindow.with(model.studio(), LorentzWindow.DEFAULT));
        PlayPanel play = new PlayPanel(model, (studio, animation) -> {}, number -> {});
        play.run(NumberProperty.speed(SpeedScale.RAPIDITY));
        play.setPlaying(false);
        Studio before = model.studio();
        Container camera = (Container) new VelocityPanel(model).component();
        Container window = (Container) new WindowPanel(model).component();
        assertThat(Components.isMarked(Components.enter(camera, "Speed", "gamma 1e9")))
                .isTrue();
        assertThat(Components.notes(camera)).anyMatch(text -> text.contains("at most that of gamma 1e8"));
        assertThat(Components.isMarked(Components.enter(window, "Speed", "gamma 1e9")))
                .isTrue();
        assertThat(Components.isMarked(Components.enter((Container) play.component(), "To", "20")))
                .isTrue();
        assertThat(Components.notes((Container) play.component())).anyMatch(text -> text.contains("gamma 1e8"));
        assertThat(model.studio()).isSameAs(before);
    }

    @Test
    void aSpeedBeyondTheGuaranteeWarns() {
        Container panel = (Container) new VelocityPanel(model).component();
        Components.enter(panel, "Speed", "gamma 1e6");
        assertThat(Components.notes(panel)).noneMatch(text -> text.contains("may be wrong"));
        Components.enter(panel, "Speed", "gamma 1e7");
        assertThat(Components.notes(panel)).anyMatch(text -> text.contains("gamma 10000000 is above 1000000"));
        model.set(model.studio().withTransformation(TransformationLaw.GALILEAN));
        assertThat(Components.notes(panel)).noneMatch(text -> text.contains("gamma"));
    }

    @Test
    void aVelocityNearThatOfLightIsToldBySpeedAndDirection() {
        Container panel = (Container) new VelocityPanel(model).component();
        model.set(model.studio().withVelocity(Velocity.of(SpeedScale.ONE_MINUS_BETA, 1e-9, new Vector3d(0, 3, -4))));
        assertThat(Components.notes(panel))
                .contains(
                        "Lorentz factor \u03b3\u00a0=\u00a022360, rapidity\u00a0\u03b7\u00a0=\u00a010.71\nVelocity \u03b2 = (1-1e-9) \u00b7 (0, 0.6, -0.8)");
    }

    @Test
    void buttonsTurnTheVelocity() {
        Container panel = (Container) new VelocityPanel(model).component();
        double speed = velocity().speed();
        Components.find(panel, JButton.class, "Backwards").doClick();
        assertThat(velocity().components().z()).isCloseTo(-speed, within(1e-12));
        Components.find(panel, JButton.class, "Sideways").doClick();
        assertThat(velocity().components().x()).isCloseTo(speed, within(1e-12));
        Components.find(panel, JButton.class, "Rest").doClick();
        assertThat(velocity().isRest()).isTrue();
        Components.enter(panel, "Direction y", "1");
        assertThat(velocity().given()).isEqualTo(new Vector3d(1, 1, 0));
    }

    @Test
    void aDirectionIsAUnitVectorUntilItIsTyped() {
        model.set(model.studio().withVelocity(Velocity.of(0.3, 0, -0.4)));
        Container panel = (Container) new VelocityPanel(model).component();
        assertThat(direction(panel)).containsExactly("0.6", "0", "-0.8");
        Components.enter(panel, "Direction y", "2");
        Components.enter(panel, "Direction z", "-1");
        assertThat(direction(panel)).as("as typed").containsExactly("0.6", "2", "-1");
        assertThat(velocity().given()).isEqualTo(new Vector3d(0.6, 2, -1));
        assertThat(velocity().speed()).isCloseTo(0.5, within(1e-15));
        model.undo();
        assertThat(direction(panel)).containsExactly("0.2683", "0.8944", "-0.3578");
    }

    /** Its components have no digits left to tell its speed from that of light. */
    @Test
    void aVeryFastCameraTurnsWithItsSpeed() {
        Velocity fast = Velocity.of(0.8640576671518558, 0.5033928364965999, 0);
        model.set(model.studio().withVelocity(fast));
        Container panel = (Container) new VelocityPanel(model).component();
        Components.find(panel, JButton.class, "Forwards").doClick();
        assertThat(velocity().gamma()).isEqualTo(fast.gamma());
        assertThat(velocity().direction()).isEqualTo(new Vector3d(0, 0, 1));
        model.set(model.studio().withVelocity(fast));
        Components.enter(panel, "Direction z", "-1");
        assertThat(velocity().gamma()).isEqualTo(fast.gamma());
        assertThat(velocity().direction().z()).isNegative();
    }

    /** Turned by 90 degrees to the right, what was ahead is x, and what was to the right is -z. */
    @ParameterizedTest
    @CsvSource({"Forwards, 1, 0", "Backwards, -1, 0", "Sideways, 0, -1"})
    void theCameraMovesAsItLooks(String button, double x, double z) {
        Studio studio = model.studio().withVelocity(Velocity.of(0, 0, 0.5));
        model.set(studio.withCamera(Descriptions.with(studio.camera(), "viewDirection", new Vector3d(2, 0, 0))));
        Container panel = (Container) new VelocityPanel(model).component();
        Components.find(panel, JButton.class, button).doClick();
        assertThat(velocity().direction()).isEqualTo(new Vector3d(x, 0, z));
        assertThat(velocity().speed()).isCloseTo(0.5, within(1e-15));
    }

    /** Artanh 0.5 is ln(3)/2; a step of the slider is 0.006. */
    @Test
    void aScreenReaderHearsAndSetsTheRapidity() {
        model.set(model.studio().withVelocity(Velocity.of(0, 0, 0.5)));
        Container panel = (Container) new VelocityPanel(model).component();
        AccessibleValue slider = Components.find(panel, JSlider.class, "Speed, slider")
                .getAccessibleContext()
                .getAccessibleValue();
        assertThat(slider.getCurrentAccessibleValue().doubleValue()).isCloseTo(Math.log(3) / 2, within(0.004));
        assertThat(slider.getMinimumAccessibleValue()).isEqualTo(0.0);
        assertThat(slider.getMaximumAccessibleValue()).isEqualTo(6.0);
        slider.setCurrentAccessibleValue(3);
        assertThat(velocity().speed()).isCloseTo(Math.tanh(3), within(1e-3));
    }

    private static List<String> direction(Container panel) {
        return Stream.of("x", "y", "z")
                .map(axis -> Components.find(panel, JTextField.class, "Direction " + axis)
                        .getText())
                .toList();
    }

    @Test
    void anotherShutterOpensSoThatTheMiddleKeepsItsTime() {
        Container panel = shutter(new ShutterPanel(model));
        JComboBox<?> models = Components.find(panel, JComboBox.class, "Shutter model");
        models.setSelectedItem(FocusSurfaceShutter.class);
        // light from the focus at distance 10 crosses the lens at time 0
        assertThat(model.studio().camera().shutter()).isEqualTo(new FocusSurfaceShutter(-10));
        models.setSelectedItem(DetectorPlaneShutter.class);
        assertThat(model.studio().camera().shutter()).isEqualTo(new DetectorPlaneShutter(1, 1));
        Components.enter(panel, "Detector distance", "0.5");
        assertThat(model.studio().camera().shutter()).isEqualTo(new DetectorPlaneShutter(1, 0.5));
        JTextField wrong = Components.enter(panel, "Detector distance", "0");
        assertThat(Components.isMarked(wrong)).isTrue();
        Components.enter(panel, "Opening time", "2");
        assertThat(model.studio().camera().shutter().openingTime()).isEqualTo(2);
        models.setSelectedItem(AperturePlaneShutter.class);
        assertThat(model.studio().camera().shutter().openingTime()).isCloseTo(1.5, within(1e-9));
    }

    @Test
    void theEyesAreSetAndWhatCannotBeIsToldAndTakenBack() {
        Container eyes = (Container) new StereoPanel(model).component();
        Container shutters = shutter(new ShutterPanel(model));
        JComboBox<?> layouts = Components.find(eyes, JComboBox.class, "Two eyes");
        JComboBox<?> models = Components.find(shutters, JComboBox.class, "Shutter model");
        layouts.setSelectedItem(StereoLayout.SIDE_BY_SIDE);
        Components.enter(eyes, "Eye distance", "0.5");
        Components.enter(eyes, "Zero parallax", "4");
        assertThat(model.studio().camera().stereo()).isEqualTo(new Stereo(StereoLayout.SIDE_BY_SIDE, 0.5, 4));
        JTextField wrong = Components.enter(eyes, "Eye distance", "8");
        assertThat(Components.isMarked(wrong)).isTrue();
        assertThat(Components.notes(eyes)).anyMatch(note -> note.contains("more than half the eyeDistance 8"));

        model.set(model.studio().withCamera(PanoramicCamera.DEFAULT));
        layouts.setSelectedItem(StereoLayout.TOP_AND_BOTTOM);
        models.setSelectedItem(DetectorPlaneShutter.class);
        assertThat(Components.notes(shutters)).anyMatch(note -> note.contains("share no detector or focus"));
        assertThat(models.getSelectedItem()).isEqualTo(AperturePlaneShutter.class);
        layouts.setSelectedItem(StereoLayout.NONE);
        models.setSelectedItem(DetectorPlaneShutter.class);
        layouts.setSelectedItem(StereoLayout.ANAGLYPH);
        assertThat(Components.notes(eyes)).anyMatch(note -> note.contains("share no detector or focus"));
        assertThat(layouts.getSelectedItem()).isEqualTo(StereoLayout.NONE);
    }

    @Test
    void whatASliderMustNotSetIsToldBeneathIt() {
        Sphere far = new Sphere("", new Vector3d(0, 0, 1e60), 1, ColouredSurface.DEFAULT);
        model.open(model.studio().withScene(List.of(far)), null);
        Container panel = shutter(new ShutterPanel(model));

        JSlider time = Components.find(panel, JSlider.class, "Opening time, slider");
        time.setValue(time.getMaximum());

        assertThat(Components.notes(panel)).anyMatch(note -> note.contains("-1e50 to 1e50"));
        assertThat(model.studio().camera().shutter().openingTime()).isZero();
    }

    /** Light in the middle reaches a detector at distance 1 at time 1, wherever the focus is. */
    @ParameterizedTest
    @ValueSource(doubles = {10, -5})
    void theDetectorOpensForTheLightFromTheFront(double focus) {
        assertThat(opened(DetectorPlaneShutter.class, focus)).isEqualTo(new DetectorPlaneShutter(1, 1));
    }

    /** A shutter model in the place of that of the studio, with the camera focused at a distance. */
    private Shutter opened(Class<?> shutter, double focus) {
        Studio focused =
                model.studio().withCamera(FocusDistance.with(model.studio().camera(), focus));
        return Shutters.replaced(focused, shutter).camera().shutter();
    }

    /**
     * Light from the focus crosses the lens at time 0, as before; of a focus behind the camera that is the time in
     * advance.
     */
    @ParameterizedTest
    @ValueSource(doubles = {10, -5})
    void theFocusSurfaceOpensForTheLightFromTheFocus(double focus) {
        assertThat(opened(FocusSurfaceShutter.class, focus)).isEqualTo(new FocusSurfaceShutter(-focus));
    }

    @Test
    void exposureAndSweepStandWithTheShutter() {
        Container panel = shutter(new ShutterPanel(model));
        Components.enter(panel, "Exposure time", "0.25");
        Components.enter(panel, "Readout time", "2");
        JComboBox<?> directions = Components.find(panel, JComboBox.class, "Rolling direction");
        directions.setSelectedItem(SweepDirection.LEFT);

        assertThat(model.studio().camera().exposureTime()).isEqualTo(0.25);
        assertThat(model.studio().camera().rollingShutter()).isEqualTo(new RollingShutter(SweepDirection.LEFT, 2));
        assertThat(Components.isMarked(Components.enter(panel, "Readout time", "-1")))
                .isTrue();
        assertThat(model.studio().camera().rollingShutter().sweep()).isEqualTo(2);
    }

    /** A model without an opening time has no controls for them, but says that they act. */
    @Test
    void onlyModelsWithAnOpeningTimeShowExposure() {
        Container panel = shutter(new ShutterPanel(model));
        JTextField field = Components.find(panel, JTextField.class, "Exposure time");
        assertThat(field.getParent().isVisible()).isTrue();
        JComboBox<?> models = Components.find(panel, JComboBox.class, "Shutter model");
        models.setSelectedItem(FixedPointSurfaceShutter.class);
        assertThat(field.getParent().isVisible()).isFalse();
        assertThat(Components.notes(panel)).noneMatch(note -> note.contains("stays open"));

        model.set(model.studio().withCamera(model.studio().camera().withExposureTime(0.5)));

        assertThat(Components.notes(panel)).anyMatch(note -> note.contains("stays open for 0.5"));
        models.setSelectedItem(AperturePlaneShutter.class);
        assertThat(field.getParent().isVisible()).isTrue();
        assertThat(field.getText()).isEqualTo("0.5");
    }

    @Test
    void theFixedPointSurfaceDoesNotForgetTheOpeningTime() {
        Container panel = shutter(new ShutterPanel(model));
        JComboBox<?> models = Components.find(panel, JComboBox.class, "Shutter model");
        models.setSelectedItem(FixedPointSurfaceShutter.class);
        models.setSelectedItem(AperturePlaneShutter.class);
        assertThat(model.studio().camera().shutter()).isEqualTo(new AperturePlaneShutter(0));
        models.setSelectedItem(FixedPointSurfaceShutter.class);
        Studio other = Studios.lattice()
                .withVelocity(Velocity.of(0, 0, 0.5))
                .withCamera(model.studio().camera().withShutter(new FixedPointSurfaceShutter()));
        model.open(other, null);
        models.setSelectedItem(AperturePlaneShutter.class);
        assertThat(model.studio())
                .as("a scene that begins with it has no time before it")
                .isEqualTo(Shutters.replaced(other, AperturePlaneShutter.class));
        assertThat(model.studio().camera().shutter().openingTime()).isNotCloseTo(0, within(1e-3));
    }

    @Test
    void timesReachThroughTheScene() {
        assertThat(new SceneSize().times(model.studio())).isEqualTo(Range.even(-20, 20));
        double[] coordinates = {0, 0, 10, 30, -45, 10, 0, 40, 10};
        MeshData triangle = new MeshData("", coordinates, new int[] {0, 1, 2}, new byte[0]);
        Studio large = model.studio()
                .withScene(List.of(new TriangleMesh("", triangle, ColouredSurface.DEFAULT, true), Sphere.DEFAULT));
        // 1.2 times 45, upwards
        assertThat(new SceneSize().times(large)).isEqualTo(Range.even(-100, 100));
    }

    /** What the panels do for each change belongs between two pictures of a screen, whatever the scene is. */
    @Test
    void scenesWithManyObjectsDoNotSlowTheSlidersDown() {
        double ratio = ProcessorTime.ratio(dragWith(200_000), dragWith(20));
        assertThat(ratio).as("times the work of 10 000 times fewer objects").isLessThan(40);
    }

    /** Drags the speed of a scene with so many objects, before the panels. */
    private static ProcessorTime.Work<RuntimeException> dragWith(int objects) {
        StudioModel scene = new StudioModel(Studio.DEFAULT, null);
        new LensPanel(scene, picking -> {});
        new ShutterPanel(scene);
        List<SceneObject> many = new ArrayList<>();
        for (int i = 0; i < objects; i++) {
            many.add(new Sphere("", new Vector3d(i, 0, 10), 0.1, ColouredSurface.DEFAULT));
        }
        scene.open(scene.studio().withScene(many), null);
        return () -> {
            for (int i = 1; i <= 11; i++) {
                scene.adjust(scene.studio().withVelocity(Velocity.of(0, 0, i / 20.0)), "drag");
            }
        };
    }

    @Test
    void lensAndFocus() {
        Container panel = (Container) new LensPanel(model, picking -> {}).component();
        Components.enter(panel, "Aperture", "0.1");
        Components.enter(panel, "Focus", "4");
        Components.enter(panel, "Field of view (\u00b0)", "60");
        Components.enter(panel, "Exposure", "1");
        Components.enter(panel, "Samples", "16");
        ThinLensCamera camera = (ThinLensCamera) model.studio().camera();
        assertThat(camera.apertureRadius()).isEqualTo(0.1);
        assertThat(FocusDistance.of(camera)).isCloseTo(4, within(1e-12));
        assertThat(camera.horizontalAngleDegrees()).isEqualTo(60);
        assertThat(camera.exposureStops()).isEqualTo(1);
        assertThat(model.studio().settings().samples()).isEqualTo(16);
        assertThat(Components.isMarked(Components.enter(panel, "Aperture", "-1")))
                .isTrue();
        assertThat(Components.isMarked(Components.enter(panel, "Field of view (\u00b0)", "180")))
                .isTrue();
    }

    @ParameterizedTest
    @CsvSource({
        "Aperture, -1",
        "Focus, 0",
        "Field of view (\u00b0), 1000",
        "Exposure, 1e400",
        "Samples, 0",
        "Opening time, 1e400",
        "Opening time, soon"
    })
    void aRefusalSpeaksOfTheFieldByItsLabel(String label, String wrong) {
        JPanel panel = new JPanel();
        panel.add(new LensPanel(model, picking -> {}).component());
        panel.add(new ShutterPanel(model).component());
        assertThat(Components.isMarked(Components.enter(panel, label, wrong))).isTrue();
        assertThat(Components.notes(panel)).anyMatch(text -> text.startsWith("\u26a0 " + label + " must be "));
    }

    @Test
    void aFocusBehindTheCameraIsShown() {
        Container panel = (Container) new LensPanel(model, picking -> {}).component();
        model.set(model.studio().withCamera(FocusDistance.with(model.studio().camera(), -5)));
        assertThat(Components.find(panel, JTextField.class, "Focus").getText()).isEqualTo("-5");
    }

    @Test
    void withoutAFocusInTheMiddleNoneIsShown() {
        Container panel = (Container) new LensPanel(model, picking -> {}).component();
        Sphere beside = new Sphere("focus", new Vector3d(5, 0, 10), 1, ColouredSurface.DEFAULT);
        model.set(model.studio().withCamera(Descriptions.with(model.studio().camera(), "focus", beside)));
        JTextField focus = Components.find(panel, JTextField.class, "Focus");
        assertThat(focus.getText()).isEqualTo("none");
        Components.press(focus, "UP");
        assertThat(Components.isMarked(focus)).isTrue();
        Components.enter(panel, "Focus", "4");
        assertThat(FocusDistance.of(model.studio().camera())).isEqualTo(4);
        Plane along = new Plane("focus", new Vector3d(1, 0, 0), new Vector3d(1, 0, 0), ColouredSurface.DEFAULT);
        Camera without = Descriptions.with(model.studio().camera(), "focusDistance", 0.0);
        model.set(model.studio().withCamera(Descriptions.with(without, "focus", along)));
        assertThat(focus.getText()).isEqualTo("\u221e");
    }

    @Test
    void aWideApertureWithOneSampleSaysThatNothingIsBlurred() {
        LensPanel lens = new LensPanel(model, picking -> {});
        Container panel = (Container) lens.component();
        Studio wide = model.studio().withCamera(Descriptions.with(model.studio().camera(), "apertureRadius", 0.2));
        lens.show(picture(wide));
        assertThat(Components.notes(panel)).containsExactly(Texts.get("lens.oneSample"));
        lens.show(picture(wide.withSettings(wide.settings().withTargetError(0.01))));
        assertThat(Components.notes(panel)).containsExactly(Texts.get("lens.otherSamples"));
        lens.show(picture(wide.withSettings(wide.settings().withSamples(2))));
        assertThat(Components.notes(panel)).containsExactly("");
        lens.show(picture(model.studio()));
        assertThat(Components.notes(panel)).containsExactly("");
    }

    private static Picture picture(Studio studio) {
        LinearImage black = new LinearImage(1, 1, new float[3]);
        return new Picture(
                studio, RenderPlan.of(studio), black, true, Duration.ZERO, 1, Double.NaN, List.of(), Picture.Flaw.NONE);
    }

    @Test
    void aPanoramaHasNoAperture() {
        model.set(model.studio().withCamera(PanoramicCamera.DEFAULT));
        Container panel = (Container) new LensPanel(model, picking -> {}).component();
        assertThat(Components.find(panel, JTextField.class, "Aperture").isEnabled())
                .isFalse();
        Components.enter(panel, "Focus", "7");
        assertThat(((PanoramicCamera) model.studio().camera()).focusDistance()).isEqualTo(7);
    }

    @Test
    void theWindowFollowsTheCameraWhileItMatches() {
        Container panel = (Container) new WindowPanel(model).component();
        JComboBox<?> kinds = Components.find(panel, JComboBox.class, "Kind of window");
        kinds.setSelectedIndex(2);
        assertThat(FrontWindow.of(model.studio())).containsInstanceOf(GalileoWindow.class);
        JButton match = Components.find(panel, JButton.class, "Match the camera");
        assertThat(match.isEnabled()).as("it matches from the beginning").isFalse();
        String follows = "The window follows the velocity of the camera until you give it another one below.";
        assertThat(Components.notes(panel)).contains(follows);
        Components.enter(panel, "Transmission", "1");
        Components.enter(panel, "Speed", "0.5");
        assertThat(Components.notes(panel)).doesNotContain(follows);
        model.set(FrontWindow.withVelocity(model.studio(), Velocity.of(0, 0, 0.75)));
        assertThat(windowVelocity().speed())
                .as("freed by a velocity of its own")
                .isEqualTo(0.5);
        match.doClick();
        assertThat(windowVelocity()).isEqualTo(Velocity.of(0, 0, 0.75));
        assertThat(match.isEnabled()).isFalse();
        model.set(FrontWindow.withVelocity(model.studio(), Velocity.of(0, 0, 0.25)));
        assertThat(windowVelocity()).as("it follows").isEqualTo(Velocity.of(0, 0, 0.25));
        kinds.setSelectedIndex(0);
        assertThat(model.studio().cameraFrame()).isEmpty();
    }

    private Velocity windowVelocity() {
        return FrontWindow.of(model.studio()).orElseThrow().velocity();
    }

    @Test
    void theLawIsChosen() {
        Container panel = (Container) LawPanel.ofTransformation(model).component();
        Components.find(panel, JRadioButton.class, "Galilean (Newton)").doClick();
        assertThat(model.studio().transformation()).isEqualTo(TransformationLaw.GALILEAN);
    }

    /** The ball passes a camera at rest: at another time it is elsewhere. */
    @Test
    void theOpeningTimeIsOfferedWhereOnlyTheSceneMoves() {
        Moving far = Descriptions.with(Moving.DEFAULT, "place", new Vector3d(-40, 0, 0));
        Studio studio = Studios.lattice().withVelocity(Velocity.REST).withScene(List.of(far));
        model.set(studio);
        assertThat(RenderPlan.of(studio).isStill()).isFalse();
        Container panel = (Container) new ShutterPanel(model).component();
        JTextField time = Components.find(panel, JTextField.class, "Opening time");
        assertThat(time.getParent().isVisible()).isTrue();
        // it passes the middle at time 80, its light comes 10 later
        Components.enter(panel, "Opening time", "89");
        assertThat(model.studio().camera().shutter().openingTime()).isEqualTo(89);
        RayLife before = RayLife.of(RenderPlan.of(studio), 320, 240, 0, 0);
        RayLife now = RayLife.of(RenderPlan.of(model.studio()), 320, 240, 0, 0);
        assertThat(before.end()).isNull();
        assertThat(now.end().object().description()).isEqualTo("sphere");
        assertThat(new SceneSize().times(studio).maximum()).isGreaterThanOrEqualTo(40);
    }

    @Test
    void whatIsMeasuredIsChosen() {
        Container panel = (Container) LawPanel.ofView(model).component();
        JRadioButton measured = Components.find(panel, JRadioButton.class, "Measured: not a photo");
        assertThat(measured.isSelected()).isFalse();
        Studio before = model.studio();
        measured.doClick();
        assertThat(model.studio()).isEqualTo(before.withView(View.MEASURED));
        model.set(before);
        assertThat(measured.isSelected()).isFalse();
    }

    @Test
    void theLawOfColoursIsChosen() {
        Container panel = (Container) LawPanel.ofColours(model).component();
        assertThat(Components.find(panel, JRadioButton.class, "As in the scene").isSelected())
                .isTrue();
        Studio before = model.studio();
        Components.find(panel, JRadioButton.class, "Doppler shift").doClick();
        assertThat(model.studio()).isEqualTo(before.withColours(ColourLaw.DOPPLER));
        assertThat(Components.notes(panel)).noneMatch(text -> text.startsWith("No effect here"));
        JCheckBox meter = Components.find(panel, JCheckBox.class, "Meter in the middle");
        meter.doClick();
        assertThat(model.studio())
                .isEqualTo(before.withColours(ColourLaw.DOPPLER).withMetering(Metering.NONE));
        model.set(model.studio().withVelocity(Velocity.REST));
        assertThat(meter.isEnabled()).as("where it would change nothing").isFalse();
        assertThat(Components.notes(panel)).anyMatch(text -> text.startsWith("No effect here"));
        model.set(before.withColours(ColourLaw.SEARCHLIGHT).withTransformation(TransformationLaw.GALILEAN));
        assertThat(Components.notes(panel)).anyMatch(text -> text.startsWith("No effect here"));
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
        Components.find((Container) panel.component(), JRadioButton.class, "Difference")
                .doClick();
        assertThat(compared.view()).isEqualTo(Comparison.DIFFERENCE);
    }

    private static void compareWith(ComparePanel panel, ComparePanel.Other other) {
        Components.find((Container) panel.component(), JComboBox.class, "Compare with")
                .setSelectedItem(other);
    }

    private ComparePanel comparePanel() {
        return new ComparePanel(model, next -> compared = next, peeking -> {}, () -> "kept");
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

    @ParameterizedTest
    @EnumSource(names = {"AT_REST", "GALILEAN_CAMERA", "UNCHANGED_COLOURS", "MEASURED"})
    void theSamePictureTwiceIsSaidToBe(ComparePanel.Other other) {
        Studio moving = Studios.lattice().withVelocity(Velocity.of(0, 0, 0.5));
        ComparePanel panel = comparePanel();
        compareWith(panel, other);
        Container shown = (Container) panel.component();
        model.set(moving.withColours(ColourLaw.DOPPLER));
        assertThat(Components.notes(shown)).containsExactly(Texts.get("compare.splitHint"));
        model.set(
                switch (other) {
                    case AT_REST -> moving.withVelocity(Velocity.of(SpeedScale.BETA, 0, new Vector3d(0, 1, 0)));
                    case MEASURED -> moving.withView(View.MEASURED);
                    case GALILEAN_CAMERA -> moving.withTransformation(TransformationLaw.GALILEAN);
                    default -> moving.withColours(ColourLaw.UNCHANGED);
                });
        assertThat(Components.notes(shown)).containsExactly("Both pictures are the same.");
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

    @Test
    void thereIsNoKeptPictureBeforeOneIsKept() {
        Container panel = (Container) comparePanel().component();
        JComboBox<?> others = Components.find(panel, JComboBox.class, "Compare with");
        assertThat(items(others))
                .doesNotContain(ComparePanel.Other.KEPT_PICTURE)
                .hasSize(7);
        for (int round = 0; round < 2; round++) {
            Components.find(panel, JButton.class, "Keep this picture").doClick();
            assertThat(others.getSelectedItem()).isEqualTo(ComparePanel.Other.KEPT_PICTURE);
            assertThat(items(others)).containsExactly((Object[]) ComparePanel.Other.values());
        }
        assertThat(Components.notes(panel)).containsExactly(Texts.get("compare.splitHint"));
    }

    private static List<Object> items(JComboBox<?> box) {
        return IntStream.range(0, box.getItemCount())
                .<Object>mapToObj(box::getItemAt)
                .toList();
    }

    @Test
    void aWantedErrorGoesIntoTheScene() {
        Container panel = (Container) new QualityPanel(model).component();
        assertThat(Components.notes(panel)).containsExactly("One sample per pixel");
        Components.enter(panel, "Target error", "0.005");
        assertThat(Quality.of(model.studio())).isEqualTo(new Quality.TargetError(0.005));
        assertThat(Components.notes(panel)).containsExactly("Samples where they are needed, error 0.005");
        Components.enter(panel, "Target error", "2");
        assertThat(Components.notes(panel).get(0)).contains("0, or from 0.000001 to 1");
        assertThat(Quality.of(model.studio())).isEqualTo(new Quality.TargetError(0.005));
        Components.enter(panel, "Target error", "0");
        assertThat(Quality.of(model.studio())).isEqualTo(new Quality.Samples(1));
    }

    @Test
    void anotherNumberOfSamplesTakesThePlaceOfAWantedError() {
        Container quality = (Container) new QualityPanel(model).component();
        Container lens = (Container) new LensPanel(model, picking -> {}).component();
        Components.enter(quality, "Target error", "0.005");
        Components.enter(lens, "Exposure", "1");
        assertThat(model.studio().settings().targetError()).isEqualTo(0.005);
        Components.enter(lens, "Samples", "16");
        assertThat(Quality.of(model.studio())).isEqualTo(new Quality.Samples(16));
        assertThat(Components.notes(quality)).containsExactly("16 samples per pixel");
    }

    /** The shutter with its details. */
    private static Container shutter(ShutterPanel panel) {
        JPanel all = new JPanel();
        all.add(panel.component());
        all.add(panel.details());
        return all;
    }
}
