package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.EventQueue;
import java.io.IOException;
import java.lang.Thread.UncaughtExceptionHandler;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.JTree;
import org.joml.Vector3dc;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.TestRun;
import tompkins.camera.PanoramicCamera;
import tompkins.io.BundledScenes;
import tompkins.io.StudioReader;
import tompkins.io.StudioWriter;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.MistakeException;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.studio.Studios;
import tompkins.surface.GalileoWindow;
import tompkins.surface.LorentzWindow;
import tompkins.ui.animate.PlayPanel;
import tompkins.ui.editor.SceneEditor;
import tompkins.ui.lesson.LessonCourse;
import tompkins.ui.lesson.LessonPanel;
import tompkins.ui.lesson.NotedStage;
import tompkins.ui.model.Settings;
import tompkins.ui.model.StudioModel;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.panel.ControlRows;
import tompkins.ui.widget.EntryField;
import tompkins.ui.widget.Look;

/** Odd entries in every field: whatever is typed, undo, saving and closing go on. */
class EveryFieldTest {

    private static final List<String> ODD =
            List.of("0", "-0", "NaN", "Infinity", "1e308", "-1e308", "1e-308", "", " ", "letters", "1-1e-300");

    private static final List<Throwable> FAULTS = new ArrayList<>();
    private static UncaughtExceptionHandler before;

    private int changes;

    @BeforeAll
    static void listen() {
        before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, fault) -> FAULTS.add(fault));
        Look.LIGHT.install();
    }

    @AfterAll
    static void leave() {
        Thread.setDefaultUncaughtExceptionHandler(before);
    }

    static Stream<Named<Studio>> studios() {
        Studio lattice = Studios.lattice();
        Studio panorama = lattice.withCamera(PanoramicCamera.DEFAULT).withVelocity(Velocity.REST);
        return Stream.concat(
                Descriptions.members(Shutter.class).stream()
                        .map(type -> Named.of(
                                type.getSimpleName(),
                                lattice.withCamera(
                                        lattice.camera().withShutter((Shutter) Descriptions.standard(type))))),
                Stream.of(
                        Named.of("panorama", panorama),
                        Named.of("Lorentz window", FrontWindow.with(lattice, LorentzWindow.DEFAULT)),
                        Named.of("Galileo window", FrontWindow.with(lattice, GalileoWindow.DEFAULT))));
    }

    @ParameterizedTest
    @MethodSource("studios")
    void theRowsOfThePanel(Studio studio) {
        StudioModel model = new StudioModel(studio, null);
        JPanel panel = new JPanel();
        PlayPanel play = new PlayPanel(model, (scene, animation) -> {}, number -> {});
        Stream.of(new ControlRows(model).component(), play.component()).forEach(panel::add);
        play.run(NumberProperty.speed(SpeedScale.BETA));
        play.setPlaying(false);
        model.reset();
        enterAll(panel, model);
        assertThat(changes).as("entries that were taken").isGreaterThanOrEqualTo(9);
    }

    @Test
    void theNumberOfALesson() throws IOException {
        StudioModel model = new StudioModel(BundledScenes.studio("lesson-02-turned-cube.json"), null);
        JPanel panel = new JPanel();
        LessonPanel lesson =
                new LessonPanel(model, new LessonCourse(new Settings((Path) null), studio -> {}), new NotedStage());
        panel.add(lesson.component());
        // the field stands on a page that comes later
        List<EntryField> fields = EntryField.in(panel).toList();
        assertThat(fields).hasSize(1);
        for (String text : ODD) {
            fields.get(0).field().setText(text);
            fields.get(0).commit();
            EntryField.takeAll(panel);
            assertNoFault("lesson", text);
            requireSavable(model.studio(), "lesson", text);
            fields.get(0).revert();
        }
    }

    @Test
    void theEditorOfTheScene() {
        Studio studio = Studios.lattice().withScene(List.of(Sphere.DEFAULT));
        StudioModel model = new StudioModel(studio, null);
        SceneEditor editor = new SceneEditor(model);
        JPanel panel = new JPanel();
        panel.add(editor.component());
        StudioPath root = StudioPath.ROOT;
        for (StudioPath part :
                List.of(root, root.then("scene").then(0), root.then("lights").then(0))) {
            editor.choose(part);
            enterAll(panel, model);
        }
        assertThat(changes).as("entries that were taken").isGreaterThan(20);
    }

    static Stream<String> scenes() {
        return Stream.of("motion-carousel", "stereo-panorama", "lesson-02-turned-cube", "fig4", "telescope", "fig2b")
                .limit(TestRun.cases(3, 6));
    }

    /** Many scenes, with all kinds of objects, cameras and backgrounds among them. */
    @ParameterizedTest
    @MethodSource("scenes")
    void everyNumberOfASceneIsReachedInTheForm(String scene) throws IOException {
        StudioModel model = new StudioModel(BundledScenes.studio(scene + ".json"), null);
        SceneEditor editor = new SceneEditor(model);
        JPanel panel = new JPanel();
        panel.add(editor.component());
        Set<String> wanted = new TreeSet<>();
        leaves(model.studio(), StudioPath.ROOT, wanted);
        Set<String> changed = new TreeSet<>();
        JTree tree = Components.find(panel, JTree.class, "tree");
        for (int row = 0; row < tree.getRowCount(); row++) {
            tree.expandRow(row);
        }
        for (int row = 0; row < tree.getRowCount(); row++) {
            tree.setSelectionRow(row);
            for (int number = 0; number < fields(panel).size(); number++) {
                changeOne(panel, number, model, changed);
            }
        }
        assertThat(wanted).hasSizeGreaterThan(30);
        wanted.removeAll(changed);
        assertThat(wanted).isEmpty();
        assertThat(model.studio()).isEqualTo(model.opened());
    }

    /** Types other values into a field until one is taken, notes what that changed, and takes it back. */
    private static void changeOne(JPanel panel, int number, StudioModel model, Set<String> changed) {
        Studio before = model.studio();
        String now = fields(panel).get(number).field().getText();
        for (String text : List.of("0.5", "7", "60", "1", "0", now + "1", now + ".0001", "another")) {
            EntryField field = fields(panel).get(number);
            field.field().setText(text);
            field.commit();
            field.revert();
            if (!model.studio().equals(before)) {
                differences(before, model.studio(), StudioPath.ROOT, changed);
                model.undo();
                return;
            }
        }
    }

    /** Adds the paths of all numbers and texts; a velocity counts as one, because it is typed in many notations. */
    private static void leaves(Object part, StudioPath path, Set<String> found) {
        if (part instanceof Number || part instanceof String || part instanceof Velocity) {
            found.add(path.toString());
        } else if (part instanceof Vector3dc) {
            List.of("x", "y", "z").forEach(axis -> found.add(path.then(axis).toString()));
        } else if (part instanceof List<?> list) {
            for (int i = 0; i < list.size(); i++) {
                leaves(list.get(i), path.then(i), found);
            }
        } else if (part instanceof Record && Descriptions.isDescription(part.getClass())) {
            Descriptions.components(part.getClass())
                    .forEach(component ->
                            leaves(Descriptions.value(component, part), path.then(component.getName()), found));
        }
    }

    private static void differences(Studio before, Studio now, StudioPath path, Set<String> found) {
        Set<String> all = new TreeSet<>();
        leaves(before, path, all);
        all.stream()
                .filter(each -> {
                    StudioPath way = StudioPath.parse(each).orElseThrow();
                    return way.length(now) == way.steps().size()
                            && !way.get(before).equals(way.get(now));
                })
                .forEach(found::add);
    }

    private void enterAll(JPanel panel, StudioModel model) {
        int fields = fields(panel).size();
        assertThat(fields).isPositive();
        for (int number = 0; number < fields; number++) {
            for (String text : ODD) {
                // forms may be made anew with each change
                EntryField field = fields(panel).get(number);
                String name = field.field().getName();
                field.field().setText(text);
                field.commit();
                // before all commands
                EntryField.takeAll(panel);
                assertNoFault(name, text);
                if (model.isModified()) {
                    changes++;
                    requireSavable(model.studio(), name, text);
                    model.undo();
                    model.reset();
                }
                EntryField.in(panel).forEach(EntryField::revert);
                assertNoFault(name, text);
            }
        }
    }

    /** The fields that can be used: not those on hidden cards, nor those of numbers that the camera does not have. */
    private static List<EntryField> fields(JPanel panel) {
        return EntryField.in(panel)
                .filter(field -> field.field().isEnabled())
                .filter(field -> {
                    Component part = field.field();
                    while (part != panel && part.isVisible()) {
                        part = part.getParent();
                    }
                    return part == panel;
                })
                .toList();
    }

    private static void requireSavable(Studio studio, String field, String text) {
        try {
            String saved = StudioWriter.writeSelfContained(studio);
            assertThat(StudioReader.read(saved, "saved", Path.of("."))).isEqualTo(studio);
        } catch (InvalidPropertyException | MistakeException refused) {
            throw new AssertionError(field + " with " + text, refused);
        }
    }

    private static void assertNoFault(String field, String text) {
        try {
            EventQueue.invokeAndWait(() -> {});
        } catch (InterruptedException | InvocationTargetException e) {
            throw new IllegalStateException(e);
        }
        List<Throwable> faults = List.copyOf(FAULTS);
        FAULTS.clear();
        assertThat(faults).as("faults of %s with %s", field, text).isEmpty();
    }
}
