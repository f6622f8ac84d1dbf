package tompkins.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import tompkins.camera.PanoramicCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;

/** Where the parts of a studio are after it has changed. */
class StudioPathTest {

    private static final SceneObject PAIR = new Group("pair", List.of(Box.DEFAULT, Sphere.DEFAULT));
    private static final SceneObject BALL = Descriptions.with(Sphere.DEFAULT, "description", "ball");
    private static final Studio BEFORE = Studio.DEFAULT.withScene(List.of(Plane.DEFAULT, PAIR, BALL));
    private static final StudioPath SCENE = StudioPath.ROOT.then("scene");

    private static StudioPath followed(StudioPath path, SceneObject... now) {
        return path.followed(BEFORE, BEFORE.withScene(List.of(now)));
    }

    @Test
    void aPartIsFoundWhereItIsNow() {
        assertThat(followed(SCENE.then(1), PAIR, BALL)).isEqualTo(SCENE.then(0));
        assertThat(followed(SCENE.then(1), BALL, Plane.DEFAULT, Box.DEFAULT, PAIR))
                .isEqualTo(SCENE.then(3));
        assertThat(followed(SCENE.then(1).then("objects").then(1), PAIR))
                .isEqualTo(SCENE.then(0).then("objects").then(1));
        assertThat(followed(SCENE.then(2).then("surface"), BALL, PAIR))
                .isEqualTo(SCENE.then(0).then("surface"));
    }

    @Test
    void aPartThatChangedKeepsItsPlace() {
        assertThat(followed(SCENE.then(2), Plane.DEFAULT, PAIR, Descriptions.with(BALL, "radius", 3.0)))
                .isEqualTo(SCENE.then(2));
    }

    @Test
    void aPartThatIsGoneLeadsToTheOneBeforeIt() {
        assertThat(followed(SCENE.then(2), Plane.DEFAULT, PAIR)).isEqualTo(SCENE.then(1));
        assertThat(followed(SCENE.then(0), PAIR, BALL)).isEqualTo(SCENE.then(0));
        assertThat(followed(SCENE.then(2))).isEqualTo(SCENE);
        StudioPath surface = StudioPath.ROOT.then("camera").then("focus").then("surface");
        assertThat(surface.followed(BEFORE, BEFORE.withCamera(PanoramicCamera.DEFAULT)))
                .isEqualTo(StudioPath.ROOT.then("camera"));
    }

    @Test
    void aWayIsWrittenWithPointsAndPlaces() {
        assertThat(StudioPath.parse("scene[0].centre.x"))
                .contains(SCENE.then(0).then("centre").then("x"));
        assertThat(StudioPath.parse("a[1][23].b[4]").orElseThrow().steps()).containsExactly("a", 1, 23, "b", 4);
        for (String other : List.of("", ".a", "a.", "a..b", "[0]", "a.[0]", "a[0]b", "a[]", "a[-1]", "a[1234567890]")) {
            assertThat(StudioPath.parse(other)).as(other).isEmpty();
        }
    }

    @Test
    void aLongWayNeedsNoDeepStack() {
        assertThat(StudioPath.parse("a" + ".a".repeat(100_000)).orElseThrow().steps())
                .hasSize(100_001);
        assertThat(StudioPath.parse("a" + "[0]".repeat(100_000) + "!")).isEmpty();
    }

    /** Its equal is another object; what is hidden is not in the picture, and so on no ray's way. */
    @Test
    void theWayToAnObjectIsFoundWhateverItIsPartOf() {
        Sphere wanted = Descriptions.with(Sphere.DEFAULT, "radius", 0.25);
        Sphere equal = Descriptions.with(Sphere.DEFAULT, "radius", 0.25);
        assertThat(equal).isEqualTo(wanted);
        Placed placed = Descriptions.with(Placed.DEFAULT, "object", new Group("inner", List.of(BALL, wanted)));
        Studio studio = BEFORE.withScene(List.of(equal, new Group("outer", List.of(PAIR, placed))));
        StudioPath inner = SCENE.then(1).then("objects").then(1).then("object");
        assertThat(StudioPath.to(studio, wanted)).contains(inner.then("objects").then(1));
        Moving moving = Descriptions.with(Moving.DEFAULT, "objects", List.of(equal, wanted));
        assertThat(StudioPath.to(BEFORE.withScene(List.of(moving)), wanted))
                .contains(SCENE.then(0).then("objects").then(1));
        ImagePointGrid grid = Descriptions.with(ImagePointGrid.DEFAULT, "object", wanted);
        assertThat(StudioPath.to(BEFORE.withCameraFrame(List.of(BALL, grid)), wanted))
                .contains(StudioPath.ROOT.then("cameraFrame").then(1).then("object"));
        assertThat(StudioPath.to(BEFORE.withScene(List.of(equal)), wanted)).isEmpty();
    }
}
