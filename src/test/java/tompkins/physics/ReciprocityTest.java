package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector2i;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.image.LinearImage;
import tompkins.light.AmbientLight;
import tompkins.light.ColourLaw;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.ImagePointGrid;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.Blinking;
import tompkins.surface.Clock;
import tompkins.surface.ColourFilter;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;
import tompkins.surface.Tiling;

/** One world in two descriptions: it does not matter who of camera and world is said to move. */
class ReciprocityTest {

    private static final double ALLOWED_SHARE = 0.0002;

    private static final Velocity REST = Velocity.REST;

    private static ColouredSurface coloured(double red, double green, double blue) {
        return new ColouredSurface(new Colour(red, green, blue), Colour.WHITE);
    }

    /** Something of everything, around the axis z. */
    private static List<SceneObject> world() {
        return List.of(
                new Plane(
                        "floor",
                        new Vector3d(0, -1.5, 0),
                        new Vector3d(0, 1, 0),
                        new Tiling(coloured(0.9, 0.8, 0.7), coloured(0.2, 0.3, 0.5), 1, 1, false)),
                new Sphere("ball", new Vector3d(1, -0.5, 8), 1, coloured(0.9, 0.3, 0.2)),
                new Box("box", new Vector3d(-3, -1.5, 9), new Vector3d(-1.5, 0, 10), coloured(0.3, 0.8, 0.4)),
                new Cylinder(
                        "rod", new Vector3d(3, -1, 9), new Vector3d(2.5, 2, 11), 0.4, true, coloured(0.5, 0.5, 0.9)),
                new Parallelogram(
                        "mirror",
                        new Vector3d(-6, -1, 14),
                        new Vector3d(9, 0, 2),
                        new Vector3d(0, 4, 0),
                        new Mirror(0.9)),
                new Sphere("glass", new Vector3d(-0.7, 0.3, 5), 0.5, new Refractive(1.5)),
                new Parallelogram(
                        "filter",
                        new Vector3d(0.6, 0.2, 4),
                        new Vector3d(0.9, 0, 0),
                        new Vector3d(0, 0.7, 0),
                        new ColourFilter(new Colour(0.9, 0.6, 0.3))),
                new Disc("clock", new Vector3d(0.2, 1.6, 9), new Vector3d(0, 0, -1), 0.8, Clock.DEFAULT),
                new Sphere(
                        "lantern",
                        new Vector3d(-2.5, 1.5, 10),
                        0.4,
                        new LuminousSurface(new Colour(0.9, 0.9, 0.4), false)),
                // these touch
                new Box("pane", new Vector3d(1.7, -1.3, 5), new Vector3d(2.3, -0.5, 5.4), new Refractive(1.5)),
                new Box("tank", new Vector3d(1.7, -1.3, 5.4), new Vector3d(2.3, -0.5, 6), new Refractive(1.333)),
                new Parallelogram(
                        "poster",
                        new Vector3d(-2.5, -1.2, 9),
                        new Vector3d(0.6, 0, 0),
                        new Vector3d(0, 0.9, 0),
                        new ColourFilter(new Colour(0.4, 0.9, 0.8))));
    }

    private static List<LightSource> lamps() {
        return List.of(
                new PointLight(new Vector3d(5, 6, 2), new Colour(0.5, 0.5, 0.4), Colour.grey(0.4), 20),
                new PointLight(new Vector3d(-3, 4, 7), new Colour(0.3, 0.4, 0.5), Colour.grey(0.2), 50));
    }

    private static Studio studio(
            List<SceneObject> scene, List<LightSource> lamps, Velocity camera, double time, ColourLaw colours) {
        List<LightSource> lights = new ArrayList<>(lamps);
        lights.add(new AmbientLight(Colour.grey(0.3)));
        return Lighting.of(Studios.dark().withScene(scene), lights)
                .withCamera(Photograph.pinhole(new Vector3d(0, 0, 1), 70, time))
                .withVelocity(camera)
                .withColours(colours)
                .withSettings(Studio.DEFAULT.settings().withSize(160, 120));
    }

    /** Objects and lamps that move together. */
    private static Studio moving(
            List<SceneObject> objects, Velocity velocity, Velocity camera, double time, ColourLaw colours) {
        return studio(
                List.of(new Moving("world", velocity, new Vector3d(), 0, objects)),
                List.of(new MovingLights(velocity, new Vector3d(), lamps())),
                camera,
                time,
                colours);
    }

    /** The world at rest, and a camera that moves. */
    private static Studio cameraMoves(Vector3dc beta, double time, ColourLaw colours) {
        return studio(world(), lamps(), Velocity.of(beta), time, colours);
    }

    /** The world moves the other way, and the camera is at rest. */
    private static Studio worldMoves(Vector3dc beta, double time, ColourLaw colours) {
        return moving(world(), Velocity.of(beta.negate(new Vector3d())), REST, time, colours);
    }

    /** Pixels in which a picture, made brighter, differs from another by more than a 255th of the whole range. */
    private static long differing(LinearImage one, LinearImage other, double brighter) {
        long differing = 0;
        for (int i = 0; i < one.rgb().length; i += 3) {
            boolean same = true;
            for (int channel = i; channel < i + 3; channel++) {
                double value = one.rgb()[channel] * brighter;
                double scale = Math.max(1, Math.abs(value));
                same &= Math.abs(value - other.rgb()[channel]) <= scale / 255;
            }
            differing += same ? 0 : 1;
        }
        return differing;
    }

    private static LinearImage render(Studio studio) {
        return new Photograph(studio).image();
    }

    private static void assertSame(LinearImage one, LinearImage other) {
        assertSame(one, other, 1);
    }

    private static void assertSame(LinearImage one, LinearImage other, double brighter) {
        assertThat(differing(one, other, brighter))
                .isLessThanOrEqualTo((long) (ALLOWED_SHARE * one.width() * one.height()));
        double sum = 0;
        for (float value : one.rgb()) {
            sum += Math.min(1, value);
        }
        assertThat(sum / one.rgb().length).as("how bright the picture is").isGreaterThan(0.002);
    }

    @ParameterizedTest
    @CsvSource({
        "UNCHANGED, 0.5, 0.1, 0.2, 0.5",
        "UNCHANGED, 0, 0, 0.8, -3",
        "UNCHANGED, -0.9, 0.1, 0.2, 6",
        "SEARCHLIGHT, 0.5, 0.1, 0.2, 0.5",
        "SEARCHLIGHT, -0.1, 0, -0.4, 2",
        "DOPPLER, 0.5, 0.1, 0.2, 0.5",
        "DOPPLER, 0, 0.1, 0.3, 1"
    })
    void whoMovesDoesNotMatter(ColourLaw colours, double x, double y, double z, double time) {
        Vector3d beta = new Vector3d(x, y, z);
        Photograph camera = new Photograph(cameraMoves(beta, time, colours));
        // the meter looks at the scene frame, which the camera that rests sees unshifted
        double metered = colours.brightness(camera.trace(80, 60).sceneDopplerFactor());

        assertSame(camera.image(), render(worldMoves(beta, time, colours)), metered);
    }

    @ParameterizedTest
    @EnumSource(names = {"LORENTZ", "GALILEAN"})
    void whoMovesDoesNotMatterToFlashes(TransformationLaw law) {
        Vector3d beta = new Vector3d(0.4, 0.1, 0.2);
        List<LightSource> lamps = List.of(
                new PointLight(new Vector3d(5, 6, 2), Colour.grey(0.6), Colour.grey(0.4), 20, new Pulse(-14, 2, 0)),
                new PointLight(new Vector3d(-3, 4, 7), Colour.grey(0.7), Colour.grey(0.2), 50, new Pulse(0.3, 1, 2.5)));
        List<LightSource> moving =
                List.of(new MovingLights(Velocity.of(beta.negate(new Vector3d())), new Vector3d(), lamps));
        Studio camera = Lighting.of(cameraMoves(beta, 0.5, ColourLaw.UNCHANGED), lamps);
        Studio world = Lighting.of(worldMoves(beta, 0.5, ColourLaw.UNCHANGED), moving);

        assertSame(render(camera.withTransformation(law)), render(world.withTransformation(law)));
    }

    @ParameterizedTest
    @EnumSource
    void velocityZeroGivesTheSameBytes(ColourLaw colours) {
        Vector3d beta = new Vector3d(0.3, 0, 0.5);
        Studio plain = cameraMoves(beta, 1, colours);
        Studio wrapped = moving(world(), REST, Velocity.of(beta), 1, colours);

        assertThat(render(wrapped).rgb()).isEqualTo(render(plain).rgb());
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, 1000, 1e6})
    void fastWorldsTogetherLookAtRest(double gamma) {
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(1, 0.2, 0.5));
        Studio together = moving(world(), velocity, velocity, 0, ColourLaw.UNCHANGED);

        assertSame(render(studio(world(), lamps(), REST, 0, ColourLaw.UNCHANGED)), render(together));
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, 1000, 1e6})
    void fastWorldBeforeACameraIsAFastCamera(double gamma) {
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(0, 0, -1));
        Velocity opposite = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(0, 0, 1));
        List<SceneObject> balls = List.of(
                new Sphere("near", new Vector3d(0, 0, 8), 1, coloured(0.9, 0.3, 0.2)),
                new Plane(
                        "floor",
                        new Vector3d(0, -1, 0),
                        new Vector3d(0, 1, 0),
                        new Tiling(coloured(0.9, 0.8, 0.7), coloured(0.2, 0.3, 0.5), 100 * gamma, 100, false)));
        Studio camera = studio(balls, lamps(), opposite, 0, ColourLaw.UNCHANGED);
        Studio world = moving(balls, velocity, REST, 0, ColourLaw.UNCHANGED);

        assertSame(render(camera), render(world));
    }

    /** The velocity turns with what is placed, its place turns and is scaled, and so is its size. */
    @Test
    void placementTurnsMotion() {
        List<SceneObject> balls = List.of(
                new Sphere("", new Vector3d(0.2, 0.1, 0), 0.3, coloured(0.9, 0.3, 0.2)),
                new Box("", new Vector3d(-1, -0.5, 0), new Vector3d(-0.5, 0.5, 0.5), coloured(0.3, 0.8, 0.4)));
        Moving inner = new Moving("", Velocity.of(0.6, 0, 0), new Vector3d(1, 2, -1), 0, balls);
        Studio placed = studio(
                List.of(new Placed("", inner, 2, new Vector3d(0, 0, 1), 90, new Vector3d(3, -4, 9))),
                lamps(),
                REST,
                8,
                ColourLaw.UNCHANGED);
        // 90 degrees take x to y and y to -x
        List<SceneObject> turned = balls.stream()
                .map(ball -> (SceneObject) new Placed("", ball, 2, new Vector3d(0, 0, 1), 90, new Vector3d()))
                .toList();
        Studio expected = studio(
                List.of(new Moving("", Velocity.of(0, 0.6, 0), new Vector3d(-4 + 3, 2 - 4, -2 + 9), 0, turned)),
                lamps(),
                REST,
                8,
                ColourLaw.UNCHANGED);

        assertSame(render(expected), render(placed));
    }

    /** Points that move with the camera are hit in whatever frame the balls rest that mark them. */
    @Test
    void imagePointsAreMarkedInEachFrame() {
        SceneObject ball = new Sphere("", new Vector3d(), 0.05, coloured(0.9, 0.3, 0.2));
        ImagePointGrid grid = new ImagePointGrid(
                "", ball, new Vector3d(-1, -1, 8), new Vector3d(2, 0, 0), new Vector3d(0, 2, 0), new Vector2i(3, 3));
        Studio studio = studio(
                List.of(new Moving("", Velocity.of(0.4, 0.2, -0.5), new Vector3d(1, 2, 3), 0, List.of(grid))),
                lamps(),
                Velocity.of(0, 0.3, 0.6),
                0,
                ColourLaw.UNCHANGED);
        Photograph photograph = new Photograph(studio);
        double pixelsPerUnit = 80 / Math.tan(Math.toRadians(35)) / 8;
        for (int column = -1; column <= 1; column++) {
            for (int row = -1; row <= 1; row++) {
                double x = 80 + pixelsPerUnit * column;
                double y = 60 - pixelsPerUnit * row;
                assertThat(photograph.trace(x, y).mainHits())
                        .as("%d, %d", column, row)
                        .hasSize(1);
            }
        }
        assertThat(photograph.trace(80 + 0.5 * pixelsPerUnit, 60).mainHits()).isEmpty();
    }

    private static List<SceneObject> blinkingWall(Surface first, Surface second) {
        return List.of(new Plane("", new Vector3d(0, 0, 10), new Vector3d(0, 0, -1), new Blinking(1, first, second)));
    }

    /** Blinking is clockwork, too: its first surface shows for half of the period. */
    @Test
    void blinkingPlaneIsTheSameForEachCamera() {
        List<SceneObject> wall = blinkingWall(coloured(0.9, 0.9, 0.9), coloured(0.1, 0.1, 0.3));
        Studio camera = studio(wall, lamps(), Velocity.of(0.6, 0, 0), 0.3, ColourLaw.UNCHANGED);

        assertSame(render(camera), render(moving(wall, Velocity.of(-0.6, 0, 0), REST, 0.3, ColourLaw.UNCHANGED)));
    }

    /** At one time of the camera the phase changes along the motion: stripes 1/(gamma v) wide in all, 1.3333. */
    @Test
    void blinkingPlaneShowsStripesWhenMeasured() {
        Studio studio = moving(
                        blinkingWall(Photograph.RED, Photograph.GREEN),
                        Velocity.of(0.6, 0, 0),
                        REST,
                        0,
                        ColourLaw.UNCHANGED)
                .withCamera(Photograph.pinhole(new Vector3d(0, 0, 1), 90, 0))
                .withView(View.MEASURED);
        Photograph photograph =
                new Photograph(studio.withSettings(studio.settings().withSize(2000, 1)));
        List<Integer> edges = IntStream.range(1, 2000)
                .filter(column -> photograph.isLit(column, 0, 0) && !photograph.isLit(column - 1, 0, 0))
                .boxed()
                .toList();

        // the plane is 20 wide in the picture
        double stripe = (edges.get(edges.size() - 1) - edges.get(0)) * 0.01 / (edges.size() - 1);
        assertThat(stripe).isCloseTo(1.33333, within(0.002));
    }
}
