package tompkins.ui.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import tompkins.camera.PanoramicCamera;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;

/** Where the parts of a studio are after it has changed. */
class StudioPathTest {

    private static final SceneObject PAIR = new Group("pair", List.of(Box.DEFAULT, Sphere.DEFAULT));
    private static final SceneObject BALL = Records.with(Sphere.DEFAULT, "description", "ball");
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
        assertThat(followed(SCENE.then(2), Plane.DEFAULT, PAIR, Records.with(BALL, "radius", 3.0)))
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
}
