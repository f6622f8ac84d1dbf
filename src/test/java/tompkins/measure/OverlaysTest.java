package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.TestRun;
import tompkins.camera.Camera;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.render.Renderer;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Cone;
import tompkins.sceneobject.Cylinder;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Lens;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Placed;
import tompkins.sceneobject.Rotating;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.shutter.DetectorPlaneShutter;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.Velocity;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.surface.LuminousSurface;
import tompkins.trace.Frame;
import tompkins.trace.RenderPlan;

/** What is drawn over pictures agrees with the traced picture within half a pixel, at several velocities. */
class OverlaysTest {

    private static final double HALF = 0.5;

    private static final FrameMotion MOTION = new FrameMotion(null, Velocity.of(-0.4, 0.1, 0.2), new Event(0, 0, 0, 0));

    static Stream<Arguments> cameras() {
        List<Velocity> velocities = List.of(
                        Velocity.of(0.3, -0.2, 0.6), Velocity.of(0.2, -0.1, 0.97), Velocity.of(0, 0.1, -0.5))
                .subList(0, TestRun.cases(2, 3));
        Vector3d position = new Vector3d(0.4, 0.3, -0.6);
        ThinLensCamera lens = Descriptions.with(
                Descriptions.with(ThinLensCamera.DEFAULT, "position", position), "horizontalAngleDegrees", 50.0);
        PanoramicCamera panorama = Descriptions.with(PanoramicCamera.DEFAULT, "position", position);
        return velocities.stream()
                .flatMap(velocity -> Stream.of(
                                lens.withShutter(new AperturePlaneShutter(0.7)),
                                lens.withShutter(new DetectorPlaneShutter(0.3, 1)),
                                panorama.withShutter(new AperturePlaneShutter(0.7)))
                        .map(camera -> Arguments.of(velocity, camera)));
    }

    private static Studio studio(Velocity velocity, Camera camera) {
        return Studio.DEFAULT.withCamera(camera).withVelocity(velocity);
    }

    /** A point that is seen at a place from a distance, in the frame in which it rests. */
    private static Vector3d point(Studio studio, FrameMotion motion, double x, double y, double distance) {
        return ProjectionTest.point(RenderPlan.of(studio.withScene(List.of())), motion, x, y, distance);
    }

    private static SceneObject placed(FrameMotion motion, SceneObject object) {
        return motion == null ? object : new Moving("", motion.velocity(), new Vector3d(), 0, List.of(object));
    }

    private static OverlayDrawing draw(Studio studio, OverlayKind kind) {
        RenderPlan plan = RenderPlan.of(studio);
        return new Overlays(Projection.of(studio), SceneShapes.of(plan.world().frames()), plan).draw(kind);
    }

    /** The points of all lines in the picture, and the middles between them: a line must not leave the curve. */
    private static List<Vector2dc> places(OverlayDrawing drawing, Studio studio) {
        List<Vector2dc> places = new ArrayList<>();
        for (List<Vector2dc> line : drawing.lines()) {
            for (int i = 1; i < line.size(); i++) {
                places.add(line.get(i));
                places.add(line.get(i - 1).lerp(line.get(i), 0.5, new Vector2d()));
            }
        }
        places.removeIf(place -> !(place.x() > 1
                && place.y() > 1
                && place.x() < studio.settings().width() - 1
                && place.y() < studio.settings().height() - 1));
        return places;
    }

    private static boolean hits(RenderPlan plan, double x, double y) {
        return Sighting.of(plan, x, y).hit() != null;
    }

    /** Whether something is hit within half a pixel in the row or in the column. */
    private static boolean isNextTo(RenderPlan plan, Vector2dc place) {
        return IntStream.rangeClosed(-16, 16)
                .mapToDouble(step -> step * HALF / 16)
                .anyMatch(step -> hits(plan, place.x() + step, place.y()) || hits(plan, place.x(), place.y() + step));
    }

    /** The object is seen a little nearer to (300, 260) than the places, and not a little farther away. */
    private static void expectEdge(RenderPlan plan, List<Vector2dc> places, double pixels) {
        for (Vector2dc place : places) {
            Vector2d outwards = place.sub(300, 260, new Vector2d()).normalize(pixels);
            assertThat(hits(plan, place.x() + outwards.x, place.y() + outwards.y))
                    .as("outside %s of %s", place, plan.studio().scene())
                    .isFalse();
            assertThat(hits(plan, place.x() - outwards.x, place.y() - outwards.y))
                    .as("inside %s of %s", place, plan.studio().scene())
                    .isTrue();
        }
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void outlinesAreTheEdgesOfSpheres(Velocity velocity, Camera camera) {
        for (FrameMotion motion : new FrameMotion[] {null, MOTION}) {
            Studio empty = studio(velocity, camera);
            Vector3d centre = point(empty, motion, 300, 260, 10);
            Studio studio =
                    empty.withScene(List.of(placed(motion, new Sphere("", centre, 0.5, LuminousSurface.DEFAULT))));
            RenderPlan plan = RenderPlan.of(studio);
            List<Vector2dc> places = places(draw(studio, OverlayKind.OUTLINES), studio);

            assertThat(places).hasSizeGreaterThan(40);
            expectEdge(plan, places, HALF);
        }
    }

    /** Rims of what is seen from the front are its edges in the picture. */
    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void rimsAreTheEdgesOfRoundPieces(Velocity velocity, Camera camera) {
        for (FrameMotion motion : new FrameMotion[] {null, MOTION}) {
            Studio empty = studio(velocity, camera);
            Vector3d centre = point(empty, motion, 300, 260, 10);
            Vector3d nearer = point(empty, motion, 300, 260, 9.5);
            Vector3d back = centre.sub(nearer, new Vector3d());
            Vector3d aslant = new Vector3d(back).add(0.1, -0.2, 0.1);
            for (SceneObject round : List.of(
                    new Disc("", centre, aslant, 0.5, LuminousSurface.DEFAULT),
                    new Lens("", centre, back, 0.5, 0, 0.1, 0.1, LuminousSurface.DEFAULT),
                    new Cone("", new Vector3d(centre).fma(0.1, back), centre, 0.5, true, LuminousSurface.DEFAULT))) {
                Studio studio = empty.withScene(List.of(placed(motion, round)));
                RenderPlan plan = RenderPlan.of(studio);
                List<Vector2dc> places = places(draw(studio, OverlayKind.LINES), studio);

                assertThat(places).hasSizeGreaterThan(30);
                expectEdge(plan, places, 1);
            }
        }
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void axesOfRodsLieOnThinRods(Velocity velocity, Camera camera) {
        for (FrameMotion motion : new FrameMotion[] {null, MOTION}) {
            Studio empty = studio(velocity, camera);
            Vector3d start = point(empty, motion, 120, 100, 8);
            Vector3d end = point(empty, motion, 500, 400, 14);
            Cylinder thick = new Cylinder("", start, end, 0.01, true, LuminousSurface.DEFAULT);
            List<Vector2dc> places =
                    places(draw(empty.withScene(List.of(placed(motion, thick))), OverlayKind.LINES), empty);
            // as thin as half a pixel at its nearer end
            Projection projection = Projection.of(empty);
            double radius = HALF * projection.pixelAngle(120, 100) * 8 * doppler(empty, 120, 100) / 2;
            Cylinder thin = new Cylinder("", start, end, radius, true, LuminousSurface.DEFAULT);
            RenderPlan plan = RenderPlan.of(empty.withScene(List.of(placed(motion, thin))));

            assertThat(places).hasSizeGreaterThan(15);
            assertThat(places).allMatch(place -> isNextTo(plan, place));
        }
    }

    /** A rod that turns like a propeller is seen bent, with its ends at up to 0.8 c; so its axis is drawn. */
    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void axesOfTurningRodsLieOnThem(Velocity velocity, Camera camera) {
        for (FrameMotion motion : new FrameMotion[] {null, MOTION}) {
            Studio empty = studio(velocity, camera);
            Vector3d centre = point(empty, motion, 310, 250, 9);
            for (View view : View.values()) {
                Studio seen = empty.withView(view);
                List<Vector2dc> places =
                        places(draw(seen.withScene(List.of(propeller(motion, centre, 0.01))), OverlayKind.LINES), seen);
                double radius = HALF * Projection.of(empty).pixelAngle(310, 250) * 8 * doppler(empty, 310, 250) / 2;
                RenderPlan plan = RenderPlan.of(seen.withScene(List.of(propeller(motion, centre, radius))));

                assertThat(places).hasSizeGreaterThan(view == View.SEEN ? 15 : -1);
                assertThat(places).allMatch(place -> isNextTo(plan, place));
            }
        }
    }

    private static SceneObject propeller(FrameMotion motion, Vector3d centre, double radius) {
        Vector3d arm = new Vector3d(1.2, 0.9, -0.4);
        Cylinder rod = new Cylinder(
                "",
                centre.sub(arm, new Vector3d()),
                centre.add(arm, new Vector3d()),
                radius,
                true,
                LuminousSurface.DEFAULT);
        Vector3d axis = new Vector3d(0.3, -0.2, 1);
        double reach = new Vector3d(axis).normalize().cross(arm).length();
        return placed(motion, new Rotating("", centre, axis, 0.8 / reach, 40, List.of(rod)));
    }

    /**
     * Spokes of a wheel that rolls past at v = 0.8, measured at the moment at which its hub is at the origin of the
     * camera's time: Kepler's equation E - e sin E = M, e = v² r/R, for the spoke at the angle M from the lowest point.
     */
    @Test
    void measuredSpokesObeyKeplersEquation() {
        double v = 0.8;
        double mean = Math.toRadians(120);
        // the axis points away; the hub moves to the right, the top runs ahead
        Cylinder spoke = new Cylinder(
                "",
                new Vector3d(0, 0, 5),
                new Vector3d(-Math.sin(mean), -Math.cos(mean), 5),
                0.01,
                true,
                LuminousSurface.DEFAULT);
        Rotating wheel = new Rotating("", new Vector3d(0, 0, 5), new Vector3d(0, 0, 1), -v, 0, List.of(spoke));
        Studio studio = Studio.DEFAULT
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d()))
                .withView(View.MEASURED)
                .withScene(List.of(new Moving("", Velocity.of(v, 0, 0), new Vector3d(), 0, List.of(wheel))));
        Projection projection = Projection.of(studio);
        List<Vector2dc> places = draw(studio, OverlayKind.LINES).lines().get(0);

        assertThat(places).hasSizeGreaterThan(5);
        for (Vector2dc place : places) {
            Vector3d look = new Vector3d(projection.direction(place.x(), place.y()));
            Vector3d point = look.mul(5 / look.z);
            // x = -(r/gamma) sin E, y = -r cos E
            double radius = Math.hypot(point.x / 0.6, point.y);
            double eccentric = Math.atan2(-point.x / 0.6, -point.y);
            double from = eccentric < 0 ? eccentric + 2 * Math.PI : eccentric;
            if (radius > 1e-6) {
                assertThat(from - v * v * radius * Math.sin(from)).isCloseTo(mean, within(1e-6));
            }
        }
    }

    private static SceneObject box(Vector3d centre) {
        return new Placed(
                "",
                new Box("", new Vector3d(-1, -0.6, -0.4), new Vector3d(1, 0.6, 0.4), LuminousSurface.DEFAULT),
                0.7,
                new Vector3d(1, 2, 3),
                40,
                centre);
    }

    /**
     * Every so many columns and rows a ray is traced to find how far a thing reaches: near what is drawn, and beyond.
     */
    private static final int STEP = 3;

    private static final int WIDE_STEP = 5 * STEP;

    /** Least and largest column and row, of the rays that hit something. */
    private static double[] extent(RenderPlan plan, double[] drawn) {
        List<Vector2dc> hit = new ArrayList<>();
        for (int x = 1; x < 640; x += STEP) {
            for (int y = 1; y < 480; y += STEP) {
                boolean near = x > drawn[0] - WIDE_STEP
                        && x < drawn[1] + WIDE_STEP
                        && y > drawn[2] - WIDE_STEP
                        && y < drawn[3] + WIDE_STEP;
                if ((near || x % WIDE_STEP == 1 && y % WIDE_STEP == 1) && hits(plan, x, y)) {
                    hit.add(new Vector2d(x, y));
                }
            }
        }
        return extent(hit);
    }

    private static double[] extent(List<Vector2dc> places) {
        return new double[] {
            places.stream().mapToDouble(Vector2dc::x).min().orElseThrow(),
            places.stream().mapToDouble(Vector2dc::x).max().orElseThrow(),
            places.stream().mapToDouble(Vector2dc::y).min().orElseThrow(),
            places.stream().mapToDouble(Vector2dc::y).max().orElseThrow()
        };
    }

    /** What is drawn reaches as far as what a traced picture shows, and lies on it. */
    private static void assertCovers(OverlayDrawing drawing, Studio drawn, RenderPlan traced) {
        List<Vector2dc> places = places(drawing, drawn);
        double[] seen = extent(places);
        double[] hit = extent(traced, seen);
        assertThat(hit[1] - hit[0]).isBetween(6.0, 500.0);
        assertThat(seen[0]).isLessThan(hit[0] + HALF);
        assertThat(seen[1]).isGreaterThan(hit[1] - HALF);
        assertThat(seen[2]).isLessThan(hit[2] + HALF);
        assertThat(seen[3]).isGreaterThan(hit[3] - HALF);
        for (Vector2dc place : places) {
            assertThat(IntStream.range(0, 16)
                            .mapToDouble(step -> step * Math.PI / 8)
                            .anyMatch(turn ->
                                    hits(traced, place.x() + HALF * Math.cos(turn), place.y() + HALF * Math.sin(turn))))
                    .as("%s", place)
                    .isTrue();
        }
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void edgesOfBoxesAreDrawn(Velocity velocity, Camera camera) {
        for (FrameMotion motion : new FrameMotion[] {null, MOTION}) {
            Studio empty = studio(velocity, camera);
            Studio studio = empty.withScene(List.of(placed(motion, box(point(empty, motion, 310, 250, 5)))));
            assertCovers(draw(studio, OverlayKind.LINES), studio, RenderPlan.of(studio));
        }
    }

    /** As a camera sees it that stands where and when this one is; and what the measured view shows. */
    @Test
    void ghostsAreWhatOtherCamerasSee() {
        Velocity velocity = Velocity.of(0.15, -0.1, 0.4);
        Camera camera = Descriptions.with(
                        Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(0.4, 0.3, -0.6)),
                        "horizontalAngleDegrees",
                        80.0)
                .withShutter(new AperturePlaneShutter(0.7));
        Studio empty = studio(velocity, camera);
        Event lens = empty.sceneFromCamera().transform(new Event(0.4, 0.3, -0.6, 0.7));
        Studio resting = empty.withVelocity(Velocity.REST)
                .withCamera(Descriptions.with(camera, "position", lens.position())
                        .withShutter(new AperturePlaneShutter(lens.time())));
        for (FrameMotion motion : new FrameMotion[] {null, MOTION}) {
            Vector3d centre = point(empty, motion, 310, 250, 6);
            for (SceneObject object : List.of(box(centre), new Sphere("", centre, 0.7, LuminousSurface.DEFAULT))) {
                Studio studio = empty.withScene(List.of(placed(motion, object)));
                assertCovers(
                        draw(studio, OverlayKind.AT_REST), studio, RenderPlan.of(resting.withScene(studio.scene())));
                assertCovers(draw(studio, OverlayKind.MEASURED), studio, RenderPlan.of(studio.withView(View.MEASURED)));
            }
        }
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void circlesHaveTheirDopplerFactor(Velocity velocity, Camera camera) {
        Studio studio = studio(velocity, camera);
        Projection projection = Projection.of(studio);
        RenderPlan plan = RenderPlan.of(studio);
        OverlayDrawing drawing = draw(studio, OverlayKind.DOPPLER);

        for (OverlayDrawing.Label label : drawing.labels()) {
            double x = label.position().x();
            double y = label.position().y();
            Sighting sighting = Sighting.of(plan, x, y);
            double factor = Double.parseDouble(label.text().substring("D = ".length()));
            double change = factor * factor * velocity.gamma() * projection.pixelAngle(x, y);
            assertThat(sighting.dopplerFactor()).isCloseTo(factor, within(HALF * change));
        }
        if (camera instanceof PanoramicCamera) {
            assertThat(drawing.labels()).hasSizeGreaterThanOrEqualTo(3);
            assertThat(drawing.labels()).anyMatch(label -> label.text().equals("D = 1"));
        }
        assertThat(draw(studio.withVelocity(Velocity.REST), OverlayKind.DOPPLER).lines())
                .isEmpty();
    }

    /** What moves has a Doppler factor of its own, that of a ray to it. */
    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void movingThingsHaveTheirOwnDopplerFactor(Velocity velocity, Camera camera) {
        Studio empty = studio(velocity, camera);
        Vector3d centre = point(empty, MOTION, 320.4, 250.3, 5);
        Studio studio =
                empty.withScene(List.of(placed(MOTION, new Sphere("ball", centre, 0.01, LuminousSurface.DEFAULT))));
        List<OverlayDrawing.Label> labels = draw(studio, OverlayKind.DOPPLER).labels();

        String text = labels.get(labels.size() - 1).text();
        Sighting sighting = Sighting.of(RenderPlan.of(studio), 320.4, 250.3);
        assertThat(sighting.hit().movesByItself()).isTrue();
        assertThat(Double.parseDouble(text.substring("D = ".length())))
                .isCloseTo(sighting.dopplerFactor(), withinPercentage(0.6));
        assertThat(sighting.dopplerFactor()).isNotCloseTo(sighting.sceneDopplerFactor(), withinPercentage(1));
    }

    private static double doppler(Studio studio, double x, double y) {
        return Math.min(1, Sighting.of(RenderPlan.of(studio), x, y).dopplerFactor());
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void dotsAreWhereThingsAreSeenAndRingsWhereTheyAre(Velocity velocity, Camera camera) {
        for (FrameMotion motion : new FrameMotion[] {null, MOTION}) {
            Studio empty = studio(velocity, camera);
            for (double distance : new double[] {3, 8}) {
                Vector3d centre = point(empty, motion, 320.4, 250.3, distance);
                Studio studio = empty.withScene(
                        List.of(placed(motion, new Sphere("ball", centre, distance * 3e-4, LuminousSurface.DEFAULT))));
                OverlayDrawing drawing = draw(studio, OverlayKind.PLACES);

                assertThat(drawing.dots()).hasSize(1);
                assertThat(drawing.dots().get(0).distance(320.4, 250.3)).isLessThan(HALF);
                RenderPlan measured = RenderPlan.of(studio.withView(View.MEASURED));
                for (Vector2dc ring : drawing.rings()) {
                    assertThat(hits(measured, ring.x(), ring.y()))
                            .as("%s", ring)
                            .isTrue();
                }
                OverlayDrawing names = draw(studio, OverlayKind.LABELS);
                assertThat(names.labels()).hasSize(1);
                assertThat(names.labels().get(0).text()).isEqualTo("ball");
                Vector2dc place = names.labels().get(0).position();
                assertThat(hits(RenderPlan.of(studio), place.x(), place.y())).isTrue();
                assertThat(names.labels().get(0).corners())
                        .hasSize(8)
                        .allMatch(corner -> corner.distance(place) > 1e-3 && corner.distance(place) < 3);
            }
        }
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("cameras")
    void gridsAndHorizonLieAtTheirAngles(Velocity velocity, Camera camera) {
        Studio studio = studio(velocity, camera);
        Projection projection = Projection.of(studio);
        RenderPlan plan = RenderPlan.of(studio);
        for (Frame frame : Frame.values()) {
            Function<Sighting, Vector3dc> direction =
                    frame == Frame.SCENE ? Sighting::sceneDirection : Sighting::cameraDirection;
            OverlayDrawing grid = draw(studio, frame == Frame.SCENE ? OverlayKind.SCENE_GRID : OverlayKind.CAMERA_GRID);
            assertThat(grid.labels()).isNotEmpty();
            for (OverlayDrawing.Label label : grid.labels()) {
                assertThat(label.frame()).isEqualTo(frame);
                assertAngle(plan, projection, label.position(), direction, Double.parseDouble(label.text()));
            }
            // each place lies on a circle or on a meridian
            double step = step(grid);
            for (Vector2dc place : places(grid, studio)) {
                assertThat(offGrid(plan, projection, place, direction, step))
                        .as("%s %s", frame, place)
                        .isLessThan(HALF);
            }
        }
        OverlayDrawing horizon = draw(studio, OverlayKind.HORIZON);
        for (OverlayDrawing.Label label : horizon.labels()) {
            assertAngle(
                    plan,
                    projection,
                    label.position(),
                    label.frame() == Frame.SCENE ? Sighting::sceneDirection : Sighting::cameraDirection,
                    90);
        }
        if (camera instanceof PanoramicCamera) {
            assertThat(horizon.labels()).hasSize(2);
        }
    }

    private static double step(OverlayDrawing grid) {
        List<Double> degrees = grid.labels().stream()
                .map(label -> Double.parseDouble(label.text()))
                .sorted()
                .toList();
        return degrees.size() < 2 ? degrees.get(0) : degrees.get(1) - degrees.get(0);
    }

    private static void assertAngle(
            RenderPlan plan,
            Projection projection,
            Vector2dc place,
            Function<Sighting, Vector3dc> direction,
            double degrees) {
        Sighting sighting = Sighting.of(plan, place.x(), place.y());
        double pixel =
                Math.toDegrees(projection.pixelAngle(place.x(), place.y())) * Math.max(1, sighting.dopplerFactor());
        assertThat(angle(plan, direction.apply(sighting))).isCloseTo(degrees, within(HALF * pixel));
    }

    private static double angle(RenderPlan plan, Vector3dc direction) {
        return Math.toDegrees(Angles.between(direction, plan.studio().velocity().direction()));
    }

    /** By how many pixels a place lies off the nearest circle, or off the nearest meridian. */
    private static double offGrid(
            RenderPlan plan,
            Projection projection,
            Vector2dc place,
            Function<Sighting, Vector3dc> direction,
            double step) {
        Sighting sighting = Sighting.of(plan, place.x(), place.y());
        Vector3dc seen = direction.apply(sighting);
        double pixel = projection.pixelAngle(place.x(), place.y());
        if (direction.apply(sighting) != sighting.cameraDirection()) {
            pixel *= sighting.dopplerFactor();
        }
        double degrees = angle(plan, seen);
        double offCircle = Math.toRadians(Math.abs(degrees - step * Math.rint(degrees / step)));
        Vector3d across = LookCone.across(plan.studio().velocity().direction()).direction(0);
        Vector3d third = plan.studio().velocity().direction().cross(across, new Vector3d());
        double azimuth = Math.toDegrees(Math.atan2(seen.dot(third), seen.dot(across)));
        double offMeridian =
                Math.toRadians(Math.abs(azimuth - 15 * Math.rint(azimuth / 15))) * Math.sin(Math.toRadians(degrees));
        return Math.min(offCircle, offMeridian) / pixel;
    }

    @Test
    void insideASkyThereIsNoOutlineAndNoName() {
        Studio studio =
                Studio.DEFAULT.withScene(List.of(new Sphere("sky", new Vector3d(), 1000, LuminousSurface.DEFAULT)));

        for (OverlayKind kind : List.of(OverlayKind.OUTLINES, OverlayKind.LABELS, OverlayKind.PLACES)) {
            OverlayDrawing drawing = draw(studio, kind);
            assertThat(drawing.lines()).isEmpty();
            assertThat(drawing.labels()).isEmpty();
            assertThat(drawing.dots()).isEmpty();
        }
        // a camera at rest has no horizon of aberration
        assertThat(draw(studio, OverlayKind.HORIZON).lines()).isEmpty();
    }

    /** The middle of the light around the place of each name, in pixels; a view of 50 degrees may hold none. */
    @ParameterizedTest
    @MethodSource("cameras")
    void namesStandBesideTheirStars(Velocity velocity, Camera camera) throws InterruptedException {
        StarSky sky = Descriptions.with(Descriptions.with(StarSky.DEFAULT, "limit", 1.7), "colour", Colour.BLACK);
        Studio studio = Descriptions.with(studio(velocity, camera), "background", sky);
        LinearImage image;
        try (Renderer renderer = new Renderer(2)) {
            image = renderer.render(RenderPlan.of(studio)).image();
        }
        List<OverlayDrawing.Label> names = draw(studio, OverlayKind.STARS).labels();

        assertThat(names).hasSizeGreaterThan(camera instanceof PanoramicCamera ? 27 : -1);
        for (OverlayDrawing.Label name : names) {
            Vector2dc place = name.position();
            if (names.stream()
                            .anyMatch(other -> other != name && other.position().distance(place) < 8)
                    || Math.abs(place.x() - image.width() / 2.0) > image.width() / 2.0 - 4
                    || Math.abs(place.y() - image.height() / 2.0) > image.height() / 2.0 - 4) {
                continue;
            }
            double sum = 0;
            Vector2d middle = new Vector2d();
            for (int row = (int) place.y() - 3; row <= place.y() + 3; row++) {
                for (int column = (int) place.x() - 3; column <= place.x() + 3; column++) {
                    double light = image.value(column, row, 1);
                    sum += light;
                    middle.add((column + 0.5) * light, (row + 0.5) * light);
                }
            }
            assertThat(middle.div(sum).distance(place)).as(name.text()).isLessThan(0.1);
        }
        assertThat(draw(studio(velocity, camera), OverlayKind.STARS).labels()).isEmpty();
    }
}
