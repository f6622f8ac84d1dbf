package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.joml.AxisAngle4d;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.PanoramicCamera;
import tompkins.image.LinearImage;
import tompkins.image.PictureDifference;
import tompkins.primitive.Primitive;
import tompkins.property.Descriptions;
import tompkins.ray.Hit;
import tompkins.ray.PixelPicture;
import tompkins.ray.Ray;
import tompkins.sceneobject.Ellipsoid;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.PrimitiveCollector;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.PictureSurface;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;

/**
 * What a moving pinhole sees is what a camera at rest sees painted on an ellipsoid: the direction n of the scene at the
 * point beta + (n along beta) + (n across)/gamma.
 */
class LookalikeEllipsoidTest {

    private static final Vector3dc UP = new Vector3d(0, 1, 0);

    /** The ellipsoid for a velocity; its middle is turned to the front. */
    private static SceneObject lookalike(Velocity velocity, Surface surface) {
        double across = 1 / velocity.gamma();
        Ellipsoid along = new Ellipsoid("", new Vector3d(), new Vector3d(across, across, 1), surface);
        SceneObject turned = new Placed("", along, 1, UP, 180, new Vector3d());
        Vector3d axis = new Vector3d(0, 0, 1).cross(velocity.components());
        double angle = Math.toDegrees(new Vector3d(0, 0, 1).angle(velocity.components()));
        return new Placed("", turned, 1, axis.length() == 0 ? UP : axis, angle, velocity.components());
    }

    /** The direction whose place on the sphere before it was stretched and turned has these coordinates. */
    private static Vector3d painted(Velocity velocity, double u, double v) {
        double longitude = 2 * Math.PI * (0.5 - u);
        double latitude = Math.PI * (v - 0.5);
        Vector3d n = new Vector3d(
                Math.cos(latitude) * Math.sin(longitude), Math.sin(latitude), Math.cos(latitude) * Math.cos(longitude));
        Vector3d axis = new Vector3d(0, 0, 1).cross(velocity.components());
        double angle = new Vector3d(0, 0, 1).angle(velocity.components());
        return axis.length() == 0
                ? n
                : new Matrix3d()
                        .rotation(new AxisAngle4d(angle, axis.normalize()))
                        .transform(n);
    }

    /** From the origin. */
    private static Ray randomRay(SplittableRandom random) {
        Vector3d d =
                new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1)).normalize();
        return Ray.from(0, 0, 0, d.x, d.y, d.z, 0);
    }

    /** Exactly, for every direction: where a ray from the origin meets the ellipsoid, and what is painted there. */
    @ParameterizedTest
    @CsvSource({"0.3, -0.2, 0.7", "0, 0, 0.8", "0.2, -0.1, 0.97"})
    void theEllipsoidHoldsTheAberration(double x, double y, double z) {
        Velocity velocity = Velocity.of(x, y, z);
        Primitive ellipsoid = PrimitiveCollector.primitivesOf(lookalike(velocity, Tiling.DEFAULT))
                .get(0);
        SplittableRandom random = new SplittableRandom(1905);
        for (int i = 0; i < 300; i++) {
            Ray ray = randomRay(random);
            Hit hit = ellipsoid.hit(ray, ellipsoid.distance(ray, Primitive.NO_HIT));
            Ray inScene = TransformationLaw.LORENTZ.sceneFromCamera(velocity).transform(ray);
            Vector3d found = painted(velocity, hit.coordinates.u(), hit.coordinates.v());
            assertThat(found.distance(inScene.dx, inScene.dy, inScene.dz)).isLessThan(1e-13 * velocity.gamma());
        }
    }

    /**
     * In the Galilean transformation light has the speed 1 for the camera: a sphere around it, painted with what is
     * seen from the point beta in it, shows the same as the moving pinhole.
     */
    @Test
    void theGalileanLookalikeIsASphere() {
        Velocity velocity = Velocity.of(0.3, -0.2, 0.7);
        Primitive sphere = PrimitiveCollector.primitivesOf(new Sphere("", new Vector3d(), 1, Tiling.DEFAULT))
                .get(0);
        SplittableRandom random = new SplittableRandom(1638);
        for (int i = 0; i < 300; i++) {
            Ray ray = randomRay(random);
            Hit hit = sphere.hit(ray, sphere.distance(ray, Primitive.NO_HIT));
            Vector3d seen =
                    new Vector3d(hit.x, hit.y, hit.z).sub(velocity.components()).normalize();
            Ray inScene = TransformationLaw.GALILEAN.sceneFromCamera(velocity).transform(ray);
            assertThat(seen.distance(inScene.dx, inScene.dy, inScene.dz)).isLessThan(1e-14);
        }
    }

    /**
     * The photograph of a moving pinhole, and that of a camera at rest in the painted ellipsoid. The difference is what
     * the panorama does not resolve: from one width to twice that, it falls to about a half.
     */
    @Test
    void paintedPanoramasMakeTheMovingPhotograph() throws InterruptedException {
        Studio figure = SceneFiles.withSamples(SceneFiles.read("telescope"), 64).withCameraFrame(List.of());
        Studio moving = figure.withSettings(figure.settings().withSize(40, 30));
        LinearImage photograph = SceneFiles.render(moving);
        double[] difference = new double[3];
        for (int i = 0; i < difference.length; i++) {
            LinearImage panorama = panorama(figure, 400 << i);
            difference[i] = PictureDifference.ofLight(photograph, SceneFiles.render(painted(moving, panorama)));
        }
        assertThat(difference[0] / difference[1]).isCloseTo(2, within(0.2));
        assertThat(difference[1] / difference[2]).isCloseTo(2, within(0.2));
    }

    /** The scenes of both show the same pixels of the same sky, where rounding does not choose between two. */
    @Test
    void theTwoSkiesAreOne() throws InterruptedException {
        Studio moving = small("whole-sky");
        LinearImage sky = SceneFiles.render(
                Descriptions.with(moving, "background", Descriptions.with(moving.background(), "filtered", false)));
        Studio painted = small("lookalike-ellipsoid");
        Placed placed = (Placed) painted.scene().get(0);
        Ellipsoid ellipsoid = (Ellipsoid) placed.object();
        SceneObject sharp =
                Descriptions.with(ellipsoid, "surface", Descriptions.with(ellipsoid.surface(), "filtered", false));
        LinearImage paint = SceneFiles.render(painted.withScene(List.of(Descriptions.with(placed, "object", sharp))));
        int differing = 0;
        for (int i = 0; i < sky.rgb().length; i++) {
            differing += Math.abs(sky.rgb()[i] - paint.rgb()[i]) > 1e-6 ? 1 : 0;
        }
        assertThat(painted.velocity().isRest()).isTrue();
        assertThat(differing).isLessThan(sky.rgb().length / 1000);
    }

    private static Studio small(String name) {
        Studio studio = SceneFiles.withSamples(SceneFiles.read(name), 1);
        return studio.withSettings(studio.settings().withSize(240, 120));
    }

    private static LinearImage panorama(Studio studio, int width) throws InterruptedException {
        Studio resting =
                SceneFiles.withSamples(studio, 1).withVelocity(Velocity.REST).withCamera(PanoramicCamera.DEFAULT);
        return SceneFiles.render(resting.withSettings(resting.settings().withSize(width, width / 2)));
    }

    private static Studio painted(Studio moving, LinearImage panorama) {
        int pixels = panorama.width() * panorama.height();
        float[] rgba = new float[4 * pixels];
        for (int i = 0; i < pixels; i++) {
            System.arraycopy(panorama.rgb(), 3 * i, rgba, 4 * i, 3);
            rgba[4 * i + 3] = 1;
        }
        PixelPicture picture = new PixelPicture("panorama", panorama.width(), panorama.height(), rgba, new byte[0]);
        Velocity velocity = moving.velocity();
        Surface surface = new PictureSurface(picture, true, true, true);
        return moving.withVelocity(Velocity.REST).withScene(List.of(lookalike(velocity, surface)));
    }
}
