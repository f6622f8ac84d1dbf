package tompkins.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.TestRun;
import tompkins.camera.CameraMotion;
import tompkins.camera.ThinLensCamera;
import tompkins.light.AmbientLight;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.ray.MeshData;
import tompkins.ray.MeshDetail;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Lens;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.sceneobject.Triangle;
import tompkins.sceneobject.TriangleMesh;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.Clear;
import tompkins.surface.ColourFilter;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;

/** Surfaces at one place are met one after the other, as with a gap that nobody sees; media there are one boundary. */
class TouchingSurfacesTest {

    private static final int RAYS = 300;

    private static final int SIZE = 64;

    private static final Refractive GLASS = new Refractive(1.5);
    private static final Refractive WATER = new Refractive(1.333);
    private static final Surface HALF_RED = new ColourFilter(new Colour(0.5, 1, 1));
    private static final Surface HALF_GREEN = new ColourFilter(new Colour(1, 0.5, 1));
    private static final Surface WHITE = new LuminousSurface(Colour.WHITE, true);
    private static final SceneObject WHITE_WALL =
            new Plane("wall", new Vector3d(0, 0, 20), new Vector3d(0, 0, -1), WHITE);

    /** Each in the scene, placed, moving, before the lens and turning. */
    @ParameterizedTest
    @EnumSource(TouchingPair.Kind.class)
    void touchingLooksAsWithAGap(TouchingPair.Kind kind) {
        List<TouchingPair.Kind> kinds = List.of(TouchingPair.Kind.values());
        int pairs = TestRun.cases(10, 500);
        int differing = 0;
        for (int i = 0; i < pairs; i++) {
            differing += differing(TouchingPair.of((long) i * kinds.size() + kinds.indexOf(kind)));
        }
        assertThat(differing).isLessThanOrEqualTo(pairs * RAYS / 1000);
    }

    /** How many rays bring other light. */
    private static int differing(TouchingPair pair) {
        RayCounts counts = new RayCounts();
        RayCounts otherCounts = new RayCounts();
        SampleTracer tracer = RenderPlan.of(pair.touching()).tracer(counts);
        SampleTracer other = RenderPlan.of(pair.other()).tracer(otherCounts);
        SplittableRandom random = new SplittableRandom(5);
        int differing = 0;
        for (int i = 0; i < RAYS; i++) {
            double x = random.nextDouble(SIZE);
            double y = random.nextDouble(SIZE);
            differing += isSame(tracer.sample(x, y, 0, 0, 0.5), other.sample(x, y, 0, 0, 0.5)) ? 0 : 1;
        }
        assertThat(counts.rays).as("rays of %s", pair.name()).isLessThanOrEqualTo(3 * otherCounts.rays);
        return differing;
    }

    private static boolean isSame(Colour one, Colour other) {
        return Math.abs(one.red() - other.red()) < 1e-6
                && Math.abs(one.green() - other.green()) < 1e-6
                && Math.abs(one.blue() - other.blue()) < 1e-6;
    }

    private static Studio studio(SceneObject... objects) {
        return Lighting.of(Studios.dark().withScene(List.of(objects)), List.of(new AmbientLight(Colour.WHITE)))
                .withCamera(Descriptions.with(
                        ThinLensCamera.DEFAULT, "focus", new Sphere("focus", new Vector3d(), 5, Clear.DEFAULT)))
                .withSettings(Studio.DEFAULT.settings().withSize(SIZE, SIZE));
    }

    private static SampleHistory middle(Studio studio) {
        return RenderPlan.of(studio).middleHistory();
    }

    private static SampleHistory life(Studio studio, double x, double y) {
        return SampleHistory.of(RenderPlan.of(studio), x, y, 0, 0);
    }

    private static SceneObject sheet(Surface surface) {
        return new Parallelogram(
                "sheet", new Vector3d(-3, -3, 10), new Vector3d(6, 0, 0), new Vector3d(0, 6, 0), surface);
    }

    private static void assertColour(Colour colour, double red, double green, double blue) {
        assertThat(isSame(colour, new Colour(red, green, blue)))
                .as("%s", colour)
                .isTrue();
    }

    /** The second one slides along the first. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.9, 0.999})
    void aFilterMayMoveOnAnother(double speed) {
        SceneObject moving = new Moving(
                "moving",
                Velocity.of(speed, 0, 0),
                new Vector3d(),
                0,
                List.of(new Plane("filter", new Vector3d(0, 0, 10), new Vector3d(0, 0, -1), HALF_GREEN)));
        assertColour(middle(studio(sheet(HALF_RED), moving, WHITE_WALL)).colour(), 0.5, 0.5, 1);
        assertColour(
                life(studio(moving, sheet(HALF_RED), WHITE_WALL), 41.3, 20.9).colour(), 0.5, 0.5, 1);
    }

    /** A disc that turns in its plane, on a sheet that rests. */
    @Test
    void aFilterMayTurnOnAnother() {
        SceneObject turning = new Rotating(
                "turning",
                new Vector3d(),
                new Vector3d(0, 0, 1),
                0.2,
                10,
                List.of(new Disc("disc", new Vector3d(0.5, 0, 10), new Vector3d(0, 0, 1), 2, HALF_GREEN)));
        assertColour(life(studio(sheet(HALF_RED), turning, WHITE_WALL), 35, 30).colour(), 0.5, 0.5, 1);
        assertColour(life(studio(turning, sheet(HALF_RED), WHITE_WALL), 35, 30).colour(), 0.5, 0.5, 1);
    }

    /** A mesh without an inside is a thin sheet, whose decal is seen from both sides of a wall. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aMeshMayBeADecal(boolean faces) {
        double[] corners = {-3, -3, 10, 3, -3, 10, 3, 3, 10};
        int[] triangle = faces ? new int[] {0, 2, 1} : new int[] {0, 1, 2};
        SceneObject decal = new TriangleMesh(
                "decal", new MeshData("", corners, triangle, MeshDetail.NONE, new byte[0]), HALF_RED, false);
        SampleHistory life = life(studio(sheet(WHITE), decal), 40, 40);
        assertColour(life.colour(), 0.5, 1, 1);
        assertThat(life.mainHits()).extracting(SampleHistory.Encounter::surface).containsExactly(HALF_RED, WHITE);
    }

    /** A ray along the common edge of pieces meets one of them. */
    @Test
    void piecesOfOneSheetLeaveNoLine() {
        Vector3d low = new Vector3d(-3, -3, 10);
        Vector3d high = new Vector3d(3, 3, 10);
        SceneObject one = new Triangle("one", low, new Vector3d(3, -3, 10), high, HALF_RED);
        SceneObject other = new Triangle("other", high, new Vector3d(-3, 3, 10), low, HALF_RED);
        double[] corners = {-3, -3, 10, 3, -3, 10, 3, 3, 10, -3, 3, 10};
        SceneObject mesh = new TriangleMesh(
                "mesh",
                new MeshData("", corners, new int[] {0, 1, 2, 2, 3, 0}, MeshDetail.NONE, new byte[0]),
                HALF_RED,
                false);
        for (double at = 20.5; at < 44; at++) {
            assertColour(life(studio(one, other, WHITE_WALL), at, SIZE - at).colour(), 0.5, 1, 1);
            assertColour(life(studio(mesh, WHITE_WALL), at, SIZE - at).colour(), 0.5, 1, 1);
        }
    }

    private static SceneObject layer(double from, double to, Surface surface) {
        return new Box("layer", new Vector3d(-9, -9, from), new Vector3d(9, 9, to), surface);
    }

    /** The way through glass and water by Snell's law. */
    @Test
    void glassAndWaterAreOneBoundary() {
        double sine = Math.sin(Math.toRadians(9));
        double x = 4 * tangent(sine) + tangent(sine / 1.5) + 2 * tangent(sine / 1.333) + 13 * tangent(sine);
        double pixel = SIZE / 2.0 * (1 + tangent(sine) / Math.tan(Math.toRadians(10)));
        SceneObject glass = layer(4, 5, GLASS);
        SceneObject water = layer(5, 7, WATER);
        for (Studio studio : List.of(studio(glass, water, WHITE_WALL), studio(water, glass, WHITE_WALL))) {
            SampleHistory life = life(studio, pixel, SIZE / 2.0);
            List<SampleHistory.Encounter> hits = life.mainHits();
            assertThat(hits).hasSize(4);
            assertThat(hits.get(3).event().position().x()).isCloseTo(x, within(1e-12));
            double normalShare = Math.pow((1.5 - 1.333) / (1.5 + 1.333), 2);
            double passed = middle(studio).mainHits().get(2).fraction();
            assertThat(passed).isCloseTo(0.96 * (1 - normalShare), within(1e-12));
        }
    }

    private static double tangent(double sine) {
        return sine / Math.sqrt((1 - sine) * (1 + sine));
    }

    /** From glass into water up to 62.7 degrees, and not to the 41.8 of glass in air. */
    @ParameterizedTest
    @CsvSource({"41, true", "43, true", "62.6, true", "62.8, false"})
    void totalReflectionIsThatOfBothMedia(double degrees, boolean passes) {
        SceneObject glass = new Box("glass", new Vector3d(-900, -900, -9), new Vector3d(900, 900, 5), GLASS);
        SceneObject water = new Box("water", new Vector3d(-900, -900, 5), new Vector3d(900, 900, 9), WATER);
        double angle = Math.toRadians(degrees);
        Studio ahead = studio(water, glass);
        Studio looking = ahead.withCamera(CameraMotion.turned(
                ahead.camera(), new Vector3d(Math.sin(angle), 0, Math.cos(angle)), new Vector3d(0, 1, 0)));
        assertThat(middle(looking).hits().stream()
                        .anyMatch(hit -> Math.abs(hit.event().position().z() - 9) < 1e-9))
                .isEqualTo(passes);
    }

    @Test
    void aFilledDoubletTakesFewRays() {
        Lens front = new Lens("front", new Vector3d(0, 0, 10), new Vector3d(0, 0, -1), 1.5, 0.2, 0.3, 0.25, GLASS);
        double gap = 1e-6;
        long apart = rays(studio(front, back(front, gap), WHITE_WALL));
        assertThat(rays(studio(front, back(front, 0), WHITE_WALL))).isBetween(SIZE * SIZE + 0L, 2 * apart);
        assertThat(rays(studio(back(front, 0), front, WHITE_WALL))).isBetween(SIZE * SIZE + 0L, 2 * apart);
    }

    /** A hollow face on the bulging back of the front lens. */
    private static Lens back(Lens front, double gap) {
        Vector3d centre = new Vector3d(0, 0, 10 + front.edgeThickness() / 2 + 0.4 + gap);
        return new Lens(
                "back", centre, new Vector3d(0, 0, -1), 1.5, 0.8, -front.backCurvature(), 0.1, new Refractive(1.7));
    }

    private static long rays(Studio studio) {
        RayCounts counts = new RayCounts();
        SampleTracer tracer = RenderPlan.of(studio).tracer(counts);
        for (int i = 0; i < SIZE * SIZE; i++) {
            Colour light = tracer.sample(i % SIZE, i / SIZE, 0);
            assertThat(light.red()).isLessThan(1 + 1e-9);
        }
        return counts.rays;
    }

    @Test
    void aCameraMeetsNothingAtItsOwnPlace() {
        SceneObject behind = layer(-1, 0, HALF_RED);
        SceneObject ahead = layer(0, 3, HALF_GREEN);
        SceneObject sheet = new Plane("sheet", new Vector3d(), new Vector3d(0, 0.6, 0.8), HALF_RED);
        List<SampleHistory.Encounter> hits =
                middle(studio(behind, ahead, sheet, WHITE_WALL)).mainHits();
        assertThat(hits).extracting(SampleHistory.Encounter::surface).containsExactly(HALF_GREEN, WHITE);
    }

    @Test
    void whatTouchesIsTold() {
        SceneObject red = sheet(new ColouredSurface(new Colour(1, 0, 0), Colour.BLACK));
        SceneObject blue = new Disc("disc", new Vector3d(0, 0, 10), new Vector3d(0, 0, 1), 2, WHITE);
        Studio rivals = studio(red, blue);
        assertColour(middle(rivals).colour(), 1, 0, 0);
        assertThat(new TouchingSurfaces(RenderPlan.of(rivals)).rivals())
                .containsExactly("\"disc\" and \"sheet\" lie at one place, and the first listed is seen");
        Studio media = studio(layer(4, 5, GLASS), layer(5, 7, WATER), WHITE_WALL);
        assertThat(new TouchingSurfaces(RenderPlan.of(media)).media())
                .containsExactly("\"layer\" and \"layer\" touch: their media meet at one boundary.");
        assertThat(new TouchingSurfaces(RenderPlan.of(studio(red, WHITE_WALL))).rivals())
                .isEmpty();
    }
}
