package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.ColouredSurface;
import tompkins.trace.RenderPlan;

/** What is said of objects that a picture does not show, held against the picture. */
class UnseenObjectsTest {

    private static final Plane FLOOR =
            new Plane("floor", new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), ColouredSurface.DEFAULT);

    private static Studio studio(SceneObject... objects) {
        return Studios.sphere().withScene(List.of(objects));
    }

    private static Sphere ball(double x, double y, double z) {
        return new Sphere("ball", new Vector3d(x, y, z), 1, ColouredSurface.DEFAULT);
    }

    private static String warning(Studio studio) {
        return new UnseenObjects(RenderPlan.of(studio)).warning().orElse("");
    }

    @Test
    void sidesAreNamed() {
        assertThat(warning(studio(FLOOR, ball(-30, 0, 8)))).endsWith("\"ball\" is to the left of the picture");
        assertThat(warning(studio(FLOOR, ball(30, 0, 8)))).endsWith("\"ball\" is to the right of the picture");
        assertThat(warning(studio(FLOOR, ball(0, 30, 8)))).endsWith("\"ball\" is above the picture");
        assertThat(warning(studio(FLOOR, ball(0, -30, 8)))).endsWith("\"ball\" is below the picture");
        assertThat(warning(studio(FLOOR, ball(0, 0, -8)))).endsWith("\"ball\" is behind the camera");
    }

    /** One that is too small for the coarse picture is in it all the same; planes are floors and walls. */
    @Test
    void whatIsInThePictureIsNotWarnedOf() {
        assertThat(warning(studio(FLOOR, ball(0, 0, 8), ball(0, 0, -8)))).isEmpty();
        assertThat(warning(studio(FLOOR, ball(13, 11, 1000)))).isEmpty();
        assertThat(warning(studio(FLOOR))).isEmpty();
        assertThat(new UnseenObjects(RenderPlan.of(studio(ball(0, 0, 8)))).sentence())
                .isEmpty();
    }

    @Test
    void othersAreToldBesideWhatIsSeen() {
        Sphere roof = new Sphere("roof", new Vector3d(0, 30, 8), 1, ColouredSurface.DEFAULT);
        assertThat(new UnseenObjects(RenderPlan.of(studio(FLOOR, ball(0, 0, 8), roof))).sentence())
                .hasValue("Not all objects are in the picture: \"roof\" is above the picture.");
    }
}
