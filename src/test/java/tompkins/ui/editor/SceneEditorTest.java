package tompkins.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.awt.Container;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.camera.Aim;
import tompkins.camera.FieldOfView;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.ThinLensCamera;
import tompkins.io.BundledScenes;
import tompkins.lesson.Lesson;
import tompkins.lesson.Prediction;
import tompkins.light.LightSource;
import tompkins.light.PointLight;
import tompkins.measure.Sighting;
import tompkins.primitive.Bounds;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.CylinderLattice;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Hidden;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Silhouette;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.sceneobject.TriangleMesh;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LorentzWindow;
import tompkins.trace.RenderPlan;
import tompkins.ui.Components;
import tompkins.ui.LightLook;
import tompkins.ui.model.StudioModel;
import tompkins.ui.widget.Wording;

@LightLook
class SceneEditorTest {

    private final StudioModel model = new StudioModel(
            Studio.DEFAULT.withScene(List.of(Sphere.DEFAULT, new Group("pair", List.of(Box.DEFAULT, Sphere.DEFAULT)))),
            null);
    private final SceneEditor editor = new SceneEditor(model);
    private final Container panel = (Container) editor.component();
    private final JTree tree = Components.find(panel, JTree.class, "tree");

    /** A teacher begins with a lesson that works, and changes it. */
    @Test
    void aSceneBecomesALesson() {
        choose("Lesson");
        @SuppressWarnings("unchecked") // the form offers types
        JComboBox<Class<?>> types = Components.find(panel, JComboBox.class, "Lesson");
        types.setSelectedItem(Lesson.class);
        assertThat(model.studio().lesson()).isEqualTo(Lesson.DEFAULT);
        choose("Lesson");
        choose("Predictions");
        editor.addElement(Prediction.class);
        Lesson lesson = (Lesson) model.studio().lesson();
        assertThat(lesson.predictions()).hasSize(3).last().isEqualTo(Prediction.DEFAULT);
    }

    @Test
    void aLineExplainsTheTypeOfAnObject() {
        editor.addElement(ImagePointGrid.class);
        assertThat(Components.notes(panel)).contains(Wording.meaning(ImagePointGrid.class));
        editor.addElement(Disc.class);
        assertThat(Components.notes(panel))
                .contains(Wording.meaning(Disc.class))
                .doesNotContain(Wording.meaning(ImagePointGrid.class));
    }

    /** Rows: studio, scene with sphere and pair, camera frame, lights, camera. */
    private void choose(String label) {
        for (int row = 0; row < tree.getRowCount(); row++) {
            if (tree.getPathForRow(row).getLastPathComponent().toString().equals(label)) {
                tree.setSelectionRow(row);
                tree.expandRow(row);
                return;
            }
        }
        throw new AssertionError("no line " + label);
    }

    private void press(String button) {
        Components.find(panel, JButton.class, button).doClick();
    }

    static List<Class<?>> objects() {
        return Descriptions.members(SceneObject.class);
    }

    @Test
    void theWindowFollowsTheCameraHere() {
        model.set(
                FrontWindow.with(model.studio(), LorentzWindow.DEFAULT).withVelocity(LorentzWindow.DEFAULT.velocity()));
        tree.setSelectionRow(0);
        Components.enter(panel, "Speed", "0.5");
        assertThat(model.studio().velocity().speed()).isEqualTo(0.5);
        assertThat(FrontWindow.matches(model.studio())).isTrue();
    }

    @Test
    void anotherTypeKeepsWhatItHasToo() {
        ColouredSurface red = new ColouredSurface(new Colour(1, 0, 0), Colour.BLACK);
        model.set(model.studio().withScene(List.of(new Sphere("mine", new Vector3d(1, 2, 3), 4, red))));
        choose("Scene");
        choose("mine");
        JComboBox<?> types = Components.find(panel, JComboBox.class, "mine");
        types.setSelectedItem(Disc.class);
        assertThat(model.studio().scene())
                .containsExactly(
                        new Disc("mine", new Vector3d(1, 2, 3), Disc.DEFAULT.normal(), Disc.DEFAULT.radius(), red));
        model.set(model.studio().withScene(List.of(Sphere.DEFAULT)));
        types.setSelectedItem(Disc.class);
        assertThat(model.studio().scene()).as("what was as usual").containsExactly(Disc.DEFAULT);

        Box far = new Box("far", new Vector3d(1, 1, 20), new Vector3d(2, 2, 21), red);
        model.set(model.studio().withScene(List.of(far)));
        types.setSelectedItem(CylinderLattice.class);
        CylinderLattice lattice = (CylinderLattice) model.studio().scene().get(0);
        assertThat(List.of(lattice.from(), lattice.to())).as("both at once").containsExactly(far.from(), far.to());
    }

    @Test
    void whatDoesNotGoTogetherInAnotherTypeIsAsUsualThere() {
        PanoramicCamera there = Descriptions.with(PanoramicCamera.DEFAULT, "position", new Vector3d(0, 0, 10));
        model.set(model.studio().withCamera(there));
        choose("Camera");
        Components.find(panel, JComboBox.class, "Camera").setSelectedItem(ThinLensCamera.class);
        assertThat(model.studio().camera()).isEqualTo(ThinLensCamera.DEFAULT);
    }

    @Test
    void theDeleteKeyRemovesWhatIsChosen() {
        choose("Scene");
        choose("pair");
        tree.getActionForKeyStroke(KeyStroke.getKeyStroke("DELETE")).actionPerformed(null);
        assertThat(model.studio().scene()).containsExactly(Sphere.DEFAULT);
    }

    @Test
    void remarksMayHaveSeveralLinesWhichAreSeenAtOnce() {
        tree.setSelectionRow(0);
        JTextArea remarks = Components.find(panel, JTextArea.class, "Remarks");
        int height = remarks.getPreferredSize().height;
        String text = "First.\n\nSecond.\n\nThird.";
        remarks.setText(text);
        Components.press(remarks, "ctrl ENTER");
        assertThat(model.studio().remarks()).isEqualTo(text);
        assertThat(remarks.getPreferredSize().height).isGreaterThan(height);
        assertThat(remarks.getInputMap().get(KeyStroke.getKeyStroke("ESCAPE")))
                .as("too much to lose at one key")
                .isNull();
    }

    /** Whatever the time and the speed: its light meets the lens now, and nothing stands before it. */
    @ParameterizedTest
    @EnumSource
    void whatMovesIsSeenAtOnce(View view) {
        Plane wall = new Plane("wall", new Vector3d(0, 0, 6), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT);
        model.set(Studio.DEFAULT
                .withScene(List.of(wall))
                .withCamera(Studio.DEFAULT.camera().withShutter(new AperturePlaneShutter(-30)))
                .withVelocity(Velocity.of(0, 0, 0.8))
                .withView(view));
        tree.setSelectionRow(0);
        editor.addElement(Moving.class);
        RenderPlan plan = RenderPlan.of(model.studio());
        Sighting middle = Sighting.of(plan, plan.middle().x(), plan.middle().y());
        assertThat(middle.hit().object()).isEqualTo(Sphere.DEFAULT);
    }

    @Test
    void aNewMeshIsPlacedAheadAndChosen() {
        model.set(Studio.DEFAULT);
        SceneEditor fresh = new SceneEditor(model);
        fresh.addElement(TriangleMesh.class);
        assertThat(((Placed) model.studio().scene().get(0)).translation()).isEqualTo(new Vector3d(0, 0, 10));
        Container form = (Container) fresh.component();
        assertThat(Components.find(form, JButton.class, "Mesh").getText()).isEqualTo("Choose a mesh\u2026");
        // whoever has chosen the file goes on with the next object
        assertThat(Components.find(form, JButton.class, "Add\u2026").isEnabled())
                .isTrue();
        fresh.addElement(Sphere.class);
        assertThat(model.studio().scene())
                .extracting(SceneObject::description)
                .containsExactly("mesh", "sphere", "floor");
    }

    /** Kinds with something to see as soon as they are added. */
    static Stream<Class<?>> visibleObjects() {
        Set<Class<?>> empty = Set.of(Group.class, Silhouette.class, Hidden.class);
        return objects().stream().filter(type -> !empty.contains(type));
    }

    /** It is shown where it is, or brought where it can be seen. */
    @ParameterizedTest
    @MethodSource("visibleObjects")
    void everyNewObjectIsSeenAtOnce(Class<?> type) {
        Plane wall = new Plane("wall", new Vector3d(0, 0, 6), new Vector3d(0, 0, -1), ColouredSurface.DEFAULT);
        model.set(Studio.DEFAULT.withScene(List.of(wall)).withVelocity(Velocity.of(0, 0, 0.8)));
        tree.setSelectionRow(0);
        Studio before = model.studio();
        editor.addElement(type);
        RenderPlan plain = RenderPlan.of(before);
        RenderPlan plan = RenderPlan.of(model.studio());
        int seen = 0;
        for (int i = 0; i < 40 * 30; i++) {
            double x = (i % 40 + 0.5) * plan.width() / 40;
            double y = (i / 40 + 0.5) * plan.height() / 30;
            seen += Sighting.of(plan, x, y).cameraDistance()
                            < Sighting.of(plain, x, y).cameraDistance()
                    ? 1
                    : 0;
        }
        assertThat(seen).isBetween(1, 600);
    }

    /** Where everything stands close together there is no room that is free, but some that is seen. */
    @Test
    void aNewObjectIsSeenInATown() throws Exception {
        Studio town = BundledScenes.studio("town-square.json");
        model.set(town);
        tree.setSelectionRow(0);
        editor.addElement(Sphere.class);
        Sphere added = (Sphere) model.studio().scene().get(town.scene().size());
        RenderPlan plan = RenderPlan.of(model.studio());
        long seen = IntStream.range(0, 40 * 30)
                .mapToObj(
                        i -> Sighting.of(plan, (i % 40 + 0.5) * plan.width() / 40, (i / 40 + 0.5) * plan.height() / 30)
                                .hit())
                .filter(hit -> hit != null && hit.object().equals(added))
                .count();
        assertThat(seen).isBetween(10L, 600L);
    }

    @Test
    void whatIsNotInThePictureSaysSo() {
        model.set(Studio.DEFAULT);
        SceneEditor fresh = new SceneEditor(model);
        Container form = (Container) fresh.component();
        fresh.addElement(Sphere.class);
        assertThat(Components.notes(form)).noneMatch(note -> note.contains("lies outside"));
        fresh.addElement(Sphere.class);
        // its left edge is 8.5 degrees from the middle, and that of the picture 10
        assertThat(((Sphere) model.studio().scene().get(1)).centre()).isEqualTo(new Vector3d(2.5, 0, 10));
        assertThat(Components.notes(form)).noneMatch(note -> note.contains("lies outside"));
        model.undo();
        model.set(model.studio().withCamera(FieldOfView.with(model.studio().camera(), 4)));
        fresh.addElement(Sphere.class);
        assertThat(Components.notes(form)).anyMatch(note -> note.contains("lies outside"));
        model.set(model.studio().withCamera(FieldOfView.with(model.studio().camera(), 120)));
        fresh.addElement(Sphere.class);
        assertThat(Components.notes(form)).noneMatch(note -> note.contains("lies outside"));
        model.set(model.studio().withCamera(Aim.along(model.studio().camera(), new Vector3d(0, 0, -1))));
        fresh.addElement(Box.class);
        assertThat(Components.notes(form)).noneMatch(note -> note.contains("lies outside"));
        assertThat(((Box) model.studio().scene().get(3)).to().z()).as("behind").isNegative();
    }

    /** An empty scene offers nothing else to choose first. */
    @Test
    void whereNothingWasChosenAnObjectIsAddedToTheScene() {
        assertThat(Components.find(panel, JButton.class, "Add\u2026").isEnabled())
                .isTrue();
        editor.addElement(Sphere.class);
        assertThat(model.studio().scene()).hasSize(3).last().isInstanceOf(Sphere.class);
        choose("Camera");
        assertThat(Components.find(panel, JButton.class, "Add\u2026").isEnabled())
                .isFalse();
    }

    @Test
    void everyKindOfLightCanBeAdded() {
        for (Class<?> type : Descriptions.members(LightSource.class)) {
            choose("Lights");
            editor.addElement(type);
        }
        assertThat(model.studio().lights())
                .hasSize(2 + Descriptions.members(LightSource.class).size());
    }

    @Test
    void objectsInGroupsAreReached() {
        choose("Scene");
        choose("pair");
        choose("Objects");
        choose("box");
        Components.enter(panel, "Description", "crate");
        Group pair = (Group) model.studio().scene().get(1);
        assertThat(pair.objects().get(0).description()).isEqualTo("crate");
        assertThat(tree.getSelectionPath().getLastPathComponent()).hasToString("crate");
    }

    @Test
    void elementsAreDuplicatedMovedHiddenShownAndRemoved() {
        choose("Scene");
        choose("sphere");
        press("Duplicate");
        Sphere copy = Descriptions.with(Sphere.DEFAULT, "description", "sphere 2");
        assertThat(model.studio().scene()).hasSize(3).element(1).isEqualTo(copy);
        press("Down");
        assertThat(model.studio().scene()).element(2).isEqualTo(copy);
        press("Hide");
        assertThat(model.studio().scene()).element(2).isEqualTo(new Hidden(copy));
        press("Hide");
        assertThat(model.studio().scene()).element(2).isEqualTo(copy);
        press("Duplicate");
        assertThat(model.studio().scene().get(3).description()).isEqualTo("sphere 3");
        press("Remove");
        press("Remove");
        assertThat(model.studio().scene()).hasSize(2).element(1).isInstanceOf(Group.class);
        model.undo();
        assertThat(model.studio().scene()).hasSize(3);
    }

    @Test
    void nothingThatWasTypedIsLostForAnotherObject() {
        choose("Scene");
        choose("sphere");
        JTextField radius = Components.enter(panel, "Radius", "-1");
        choose("pair");
        assertThat(Components.find(panel, JTextField.class, "Radius")).isSameAs(radius);
        assertThat(radius.getText()).isEqualTo("-1");
        press("Duplicate");
        assertThat(radius.getText()).isEqualTo("-1");
        assertThat(model.studio().scene()).hasSize(2);
        assertThat(tree.getSelectionPath().getLastPathComponent()).hasToString("sphere");

        Components.find(panel, JTextField.class, "Description").setText("ball");
        radius.setText("0.25");
        choose("pair");
        assertThat(tree.getSelectionPath().getLastPathComponent()).hasToString("pair");
        Sphere ball = (Sphere) model.studio().scene().get(0);
        assertThat(ball.description()).isEqualTo("ball");
        assertThat(ball.radius()).isEqualTo(0.25);
    }

    @Test
    void anObjectIsRemovedWithAWrongValueOfIt() {
        choose("Scene");
        choose("sphere");
        Components.enter(panel, "Radius", "-1");
        press("Remove");
        assertThat(model.studio().scene()).singleElement().isInstanceOf(Group.class);
    }

    @Test
    void undoChoosesWhatWasCopiedAndNotItsNeighbour() {
        choose("Scene");
        tree.setSelectionRow(2);
        press("Duplicate");
        model.undo();
        assertThat(tree.getSelectionPath().getLastPathComponent().toString()).isEqualTo(Sphere.DEFAULT.description());
        press("Remove");
        assertThat(model.studio().scene()).extracting(SceneObject::description).containsExactly("pair");
    }

    /** As the object would be without being hidden: its type, its values, and what it is made of. */
    @Test
    void aHiddenObjectIsEditedLikeAnyOther() {
        choose("Scene");
        choose("sphere");
        press("Hide");
        Components.enter(panel, "Radius", "0.25");
        Sphere smaller = Descriptions.with(Sphere.DEFAULT, "radius", 0.25);
        assertThat(model.studio().scene()).first().isEqualTo(new Hidden(smaller));
        assertThat(Components.find(panel, JComboBox.class, "sphere").getSelectedItem())
                .isEqualTo(Sphere.class);

        choose("pair");
        press("Hide");
        choose("pair (hidden)");
        choose("Objects");
        choose("box");
        press("Remove");
        assertThat(model.studio().scene())
                .containsExactly(new Hidden(smaller), new Hidden(new Group("pair", List.of(Sphere.DEFAULT))));
        choose("sphere (hidden)");
        press("Hide");
        assertThat(model.studio().scene()).first().isEqualTo(smaller);
    }

    @Test
    void hidingIsNoTypeToChoose() {
        choose("Scene");
        choose("sphere");
        JComboBox<?> types = Components.find(panel, JComboBox.class, "sphere");
        assertThat(types.getItemCount()).isEqualTo(objects().size() - 1);
    }

    /** As that of the camera. */
    @Test
    void theVelocityOfWhatMovesIsGivenInAnyNotation() {
        double gamma = 1.25;
        editor.addElement(Moving.class);
        Studio before = model.studio();
        Components.enter(panel, "Speed", "179875.4748 km/s");
        assertThat(moving().velocity().gamma()).isCloseTo(gamma, withinPercentage(1e-6));
        assertThat(moving().velocity().components().y()).isZero();
        assertThat(model.studio().velocity()).as("that of the camera").isEqualTo(before.velocity());
        Components.enter(panel, "Direction x", "0");
        Components.enter(panel, "Direction y", "-1");
        assertThat(moving().velocity().gamma()).isCloseTo(gamma, withinPercentage(1e-6));
        assertThat(moving().velocity().components().y()).isNegative();
        for (int i = 0; i < 10 && !model.studio().equals(before); i++) {
            model.undo();
        }
        assertThat(model.studio()).isEqualTo(before);
    }

    private Moving moving() {
        return (Moving) model.studio().scene().get(2);
    }

    @Test
    void anObjectThatMovesIsChosenFromOutside() {
        Moving inner = new Moving("inner", Velocity.of(0.5, 0, 0), new Vector3d(), 0, List.of(Sphere.DEFAULT));
        Moving outer = new Moving("outer", Velocity.of(0, 0.5, 0), new Vector3d(), 0, List.of(Disc.DEFAULT, inner));
        model.set(model.studio().withScene(List.of(outer)));
        editor.choose(StudioPath.to(model.studio(), inner.objects().get(0)).orElseThrow());
        assertThat(tree.getSelectionPath().getLastPathComponent()).hasToString("sphere");
    }

    @Test
    void theCopyOfAHiddenObjectHasANameOfItsOwn() {
        model.set(model.studio().withScene(List.of(new Hidden(Sphere.DEFAULT))));
        choose("Scene");
        tree.setSelectionRow(2);
        press("Duplicate");
        assertThat(model.studio().scene())
                .extracting(SceneObject::description)
                .containsExactly(Sphere.DEFAULT.description(), Sphere.DEFAULT.description() + " 2");
    }

    static Stream<Class<?>> bodies() {
        return Stream.of(
                Sphere.class, Box.class, Triangle.class, Silhouette.class, CylinderLattice.class, Placed.class);
    }

    /** New objects of all kinds at rest keep apart from each other, whoever was there first. */
    @ParameterizedTest
    @MethodSource("bodies")
    void newObjectsDoNotLandInEachOther(Class<?> type) {
        model.set(Studio.DEFAULT);
        SceneEditor fresh = new SceneEditor(model);
        fresh.addElement(Sphere.class);
        for (int i = 0; i < 3; i++) {
            fresh.addElement(type);
        }
        List<SceneObject> objects = model.studio().scene().stream()
                .filter(object -> !(object instanceof Plane))
                .toList();
        assertThat(objects).hasSize(4);
        for (SceneObject one : objects) {
            for (SceneObject other : objects) {
                assertThat(one == other || areApart(bounds(one), bounds(other)))
                        .as(one + " and " + other)
                        .isTrue();
            }
        }
    }

    private static Bounds bounds(SceneObject object) {
        return PrimitiveCollector.primitivesOf(object).stream()
                .map(Primitive::bounds)
                .reduce(Bounds::with)
                .orElseThrow();
    }

    private static boolean areApart(Bounds one, Bounds other) {
        return one.maxX() < other.minX()
                || other.maxX() < one.minX()
                || one.maxZ() < other.minZ()
                || other.maxZ() < one.minZ();
    }

    @Test
    void theFirstObjectStandsOnAFloor() {
        model.set(Studio.DEFAULT);
        SceneEditor fresh = new SceneEditor(model);
        fresh.addElement(Sphere.class);
        assertThat(model.studio().scene()).hasSize(2);
        assertThat(model.studio().scene().get(0)).isEqualTo(Sphere.DEFAULT);
        Plane floor = (Plane) model.studio().scene().get(1);
        assertThat(floor.point().y()).isEqualTo(-1);
        assertThat(floor.normal()).isEqualTo(new Vector3d(0, 1, 0));
        fresh.addElement(Sphere.class);
        assertThat(model.studio().scene()).hasSize(3);
        model.set(Studio.DEFAULT);
        fresh.addElement(Plane.class);
        assertThat(model.studio().scene()).containsExactly(Plane.DEFAULT);
    }

    @Test
    void aNewLampStandsElsewhereAndSaysThatItAddsLight() {
        model.set(Studio.DEFAULT);
        SceneEditor fresh = new SceneEditor(model);
        fresh.choose(StudioPath.ROOT.then("lights"));
        fresh.addElement(PointLight.class);
        assertThat(Components.notes((Container) fresh.component())).anyMatch(note -> note.contains("lights before: 2"));
        fresh.addElement(PointLight.class);
        assertThat(model.studio().lights().stream()
                        .filter(PointLight.class::isInstance)
                        .map(light -> ((PointLight) light).position())
                        .distinct())
                .hasSize(3);
    }
}
