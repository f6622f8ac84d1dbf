package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.Cameras;
import tompkins.camera.ThinLensCamera;
import tompkins.light.ColourLaw;
import tompkins.light.LightSource;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.Blinking;
import tompkins.surface.Clock;
import tompkins.surface.ColouredSurface;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.trace.SampleHistory;

/** What closed formulas say of things in motion, read from pictures and rays of a camera at rest. */
class MovingFactsTest {

    private static final Vector3dc FORWARDS = new Vector3d(0, 0, 1);
    private static final ColouredSurface DULL = new ColouredSurface(Colour.WHITE, Colour.BLACK);

    private static Studio studio(List<SceneObject> scene, List<LightSource> lights, ThinLensCamera camera, int size) {
        return Lighting.of(Studios.dark().withScene(scene), lights)
                .withCamera(camera)
                .withSettings(Studio.DEFAULT.settings().withSize(size, size));
    }

    private static Moving moving(double speed, Vector3dc place, SceneObject... objects) {
        return new Moving("moving", Velocity.of(speed, 0, 0), place, 0, List.of(objects));
    }

    private static SampleHistory.Encounter hit(List<SceneObject> scene, Vector3dc view, double time) {
        return new Photograph(studio(scene, List.of(), Photograph.pinhole(view, 1, time), 100))
                .trace(50, 50)
                .mainHits()
                .get(0);
    }

    /** The parts of a moving cube of side 2, red in front and green behind, by the width that each is seen to have. */
    @ParameterizedTest
    @CsvSource({"SEEN, 1.2, 1.6", "MEASURED, 1.2, 0"})
    void cubeLooksTurned(View view, double front, double side) {
        double distance = 4000;
        Moving cube = moving(
                0.8,
                new Vector3d(0, 0, distance),
                new Parallelogram(
                        "front", new Vector3d(-1, -1, 0), new Vector3d(2, 0, 0), new Vector3d(0, 2, 0), Photograph.RED),
                new Parallelogram(
                        "behind",
                        new Vector3d(-1, -1, 0),
                        new Vector3d(0, 0, 2),
                        new Vector3d(0, 2, 0),
                        Photograph.GREEN));
        // seen straight across: its light leaves at time 0; measured then
        double time = view == View.SEEN ? distance : 0;
        double angle = 2 * Math.toDegrees(Math.atan(4 / distance));
        Photograph photograph =
                new Photograph(studio(List.of(cube), List.of(), Photograph.pinhole(FORWARDS, angle, time), 800)
                        .withView(view));

        assertThat(width(photograph, 0) / 100).isCloseTo(front, within(0.011));
        assertThat(width(photograph, 1) / 100).isCloseTo(side, within(0.011));
    }

    /** Lit pixels of the middle row. */
    private static double width(Photograph photograph, int channel) {
        int width = 0;
        for (int column = 0; column < photograph.image().width(); column++) {
            width += photograph.isLit(column, photograph.image().height() / 2, channel) ? 1 : 0;
        }
        return width;
    }

    /** The lamp at height 3 moves with 0.6 and is overhead at time 0. */
    @ParameterizedTest
    @CsvSource({"0, -2.25", "3, 0"})
    void lampShinesFromWhereItWas(double time, double lampX) {
        Plane floor = new Plane("floor", new Vector3d(), new Vector3d(0, 1, 0), DULL);
        LightSource lamp = new MovingLights(
                Velocity.of(0.6, 0, 0),
                new Vector3d(0, 3, 0),
                List.of(new PointLight(new Vector3d(), Colour.WHITE, Colour.BLACK, 1)));
        // the camera, one unit above the floor, sees the point below it as it was one unit of time before
        Vector3dc down = new Vector3d(0, -1, 0);
        ThinLensCamera camera = at(new Vector3d(0, 1, 0), Photograph.pinhole(down, 1, time + 1));
        SampleHistory life = new Photograph(studio(List.of(floor), List.of(lamp), camera, 100)).trace(50, 50);

        double cosine = 3 / Math.hypot(3, lampX);
        assertThat(life.colour().red()).isCloseTo(cosine, within(1e-9));
    }

    private static ThinLensCamera at(Vector3dc position, ThinLensCamera camera) {
        return Cameras.lens(
                position,
                camera.viewDirection(),
                camera.topDirection(),
                camera.horizontalAngleDegrees(),
                camera.verticalAngleDegrees(),
                camera.apertureRadius(),
                camera.focus(),
                camera.exposureStops(),
                camera.shutter());
    }

    @Test
    void lampOverheadShinesObliquelyOnAMovingFloor() {
        Plane floor = new Plane("floor", new Vector3d(), new Vector3d(0, 1, 0), DULL);
        Moving moving = moving(0.6, new Vector3d(), floor);
        LightSource lamp = new PointLight(new Vector3d(0, 1e9, 0), Colour.WHITE, Colour.BLACK, 1);
        Studio studio = studio(
                List.of(moving),
                List.of(lamp),
                at(new Vector3d(0, 1, 0), Photograph.pinhole(new Vector3d(0, -1, 0), 1, 0)),
                100);

        assertThat(new Photograph(studio).trace(50, 50).colour().red()).isCloseTo(0.8, within(1e-7));
        // 1.25 times the frequency at the floor, and back to the scene across the motion: D2 = 1/gamma = 0.8
        double seen = new Photograph(studio.withColours(ColourLaw.SEARCHLIGHT))
                .trace(50, 50)
                .colour()
                .red();
        assertThat(seen).isCloseTo(0.8 * Math.pow(1.25 * 0.8, 4), within(1e-6));
    }

    /** Where the clock's centre is seen is worked out here, along with when. */
    @ParameterizedTest
    @CsvSource({"-1e4, 2", "1e4, 0.5"})
    void clocksTickAsTheyAreSeen(double start, double rate) {
        Moving clock = moving(0.6, new Vector3d(start, 0, 0.001), facing(0.6));
        Vector3dc view = new Vector3d(Math.signum(start), 0, 0);
        // head-on: its light of time 0 gets here at the time of its distance
        double first = Math.abs(start);
        double one = hit(List.of(clock), view, first).rest().clockReading();
        double two = hit(List.of(clock), view, first + 10).rest().clockReading();

        assertThat((two - one) / 10).isCloseTo(rate, within(1e-4));
    }

    /** A dial that is seen from both sides along the motion. */
    private static SceneObject facing(double speed) {
        return new Disc("dial", new Vector3d(), new Vector3d(speed, 0, 0), 100, Clock.DEFAULT);
    }

    /**
     * A hand as it is read from pictures, by the middle of its pixels. Its rate follows from two pictures of a clock
     * that is seen straight across, at 1/gamma, and of one that is nearest, at gamma.
     */
    @ParameterizedTest
    @CsvSource({"seen, 0.8", "nearest, 1.25"})
    void clockRateIsReadFromTwoPictures(String when, double rate) {
        double distance = 1000;
        // a small dial, so that all of it shows one time
        SceneObject dial = new Disc(
                "dial",
                new Vector3d(),
                new Vector3d(0, 0, -1),
                0.02,
                new Clock(12, Photograph.RED, new LuminousSurface(new Colour(0, 1, 0), false), false));
        Moving clock = moving(0.6, new Vector3d(0, 0, distance), dial);
        double middle = when.equals("seen") ? distance : 0;
        double half = 1;
        double turn = handAngle(clock, middle + half) - handAngle(clock, middle - half);
        double reading = Math.abs(Math.IEEEremainder(turn, 2 * Math.PI)) / (2 * Math.PI) * 12;

        assertThat(reading / (2 * half)).isCloseTo(rate, within(0.02));
    }

    /** The angle of the green hand on the dial, in the coordinates of the dial. */
    private static double handAngle(Moving clock, double time) {
        double distance = clock.place().z();
        double emission = emission(clock.velocity().components().x(), distance, time);
        double x = 0.6 * emission;
        Vector3d view = new Vector3d(x, 0, distance);
        double angle = 2 * Math.toDegrees(Math.atan(0.024 / view.length()));
        Photograph photograph =
                new Photograph(studio(List.of(clock), List.of(), Photograph.pinhole(view, angle, time), 300));
        Vector2d sum = new Vector2d();
        for (int row = 0; row < 300; row++) {
            for (int column = 0; column < 300; column++) {
                if (photograph.isLit(column, row, 1)) {
                    Vector3d place = photograph
                            .trace(column + 0.5, row + 0.5)
                            .mainHits()
                            .get(0)
                            .rest()
                            .event()
                            .position();
                    if (Math.hypot(place.x, place.y) < 0.0164) {
                        sum.add(place.x, place.y);
                    }
                }
            }
        }
        return Math.atan2(sum.x, sum.y);
    }

    /** When the light has left that gets to the origin at a time: |(v t, distance)| = time - t. */
    private static double emission(double speed, double distance, double time) {
        double gammaSquared = 1 / (1 - speed * speed);
        return gammaSquared * (time - Math.sqrt(time * time - (time * time - distance * distance) / gammaSquared));
    }

    /** Of clocks that go together and are 1 apart in their rest frame, the front one shows less, measured. */
    @Test
    void clockInFrontIsBehind() {
        Moving clocks = moving(
                0.6,
                new Vector3d(0, 0, 5),
                new Plane("wall", new Vector3d(), new Vector3d(0, 0, -1), Photograph.WHITE));
        Photograph photograph =
                new Photograph(studio(List.of(clocks), List.of(), Photograph.pinhole(FORWARDS, 40, 2), 200)
                        .withView(View.MEASURED));
        SampleHistory.Rest left = photograph.trace(50, 100).mainHits().get(0).rest();
        SampleHistory.Rest right = photograph.trace(150, 100).mainHits().get(0).rest();
        double apart = right.event().x() - left.event().x();

        assertThat((right.clockReading() - left.clockReading()) / apart).isCloseTo(-0.6, within(1e-12));
        // contracted: 1 apart is 0.8 in the picture
        double inPicture = 100 / 200.0 * 2 * Math.tan(Math.toRadians(20)) * 5;
        assertThat(inPicture / apart).isCloseTo(0.8, within(1e-12));
    }

    @Test
    void blinkingPlaneShowsStripesWhenMeasured() {
        Moving plane = moving(
                0.6,
                new Vector3d(0, 0, 10),
                new Plane(
                        "wall",
                        new Vector3d(),
                        new Vector3d(0, 0, -1),
                        new Blinking(1, Photograph.RED, Photograph.GREEN)));
        Photograph photograph =
                new Photograph(studio(List.of(plane), List.of(), Photograph.pinhole(FORWARDS, 90, 0), 2000)
                        .withView(View.MEASURED));
        int first = -1;
        int last = -1;
        int edges = 0;
        for (int column = 1; column < 2000; column++) {
            if (photograph.isLit(column, 1000, 0) && !photograph.isLit(column - 1, 1000, 0)) {
                first = first < 0 ? column : first;
                last = column;
                edges++;
            }
        }
        // the plane is 20 wide in the picture
        double stripe = (last - first) * 0.01 / (edges - 1);
        assertThat(stripe).isCloseTo(1.33333, within(0.002));
    }

    @ParameterizedTest
    @CsvSource({"0.5, 0, 0, 0.33333333333", "-0.5, 0, 0, 3", "0.5, 30, 10.2078, -1", "-0.5, 30, 77.5880, -1"})
    void movingMirrorReflects(double speed, double degrees, double expected, double ratio) {
        Moving mirror = new Moving(
                "mirror",
                Velocity.of(0, 0, speed),
                new Vector3d(0, 0, 10),
                0,
                List.of(new Plane("mirror", new Vector3d(), new Vector3d(0, 0, -1), new Mirror(1))));
        Plane wall = new Plane("wall", new Vector3d(0, 0, -50), FORWARDS, Photograph.WHITE);
        Photograph photograph = new Photograph(
                studio(List.of(mirror, wall), List.of(), Photograph.pinhole(Photograph.level(degrees), 1, 0), 100));
        List<SampleHistory.Encounter> hits = photograph.trace(50, 50).mainHits();
        Vector3d way = new Vector3d(hits.get(1).event().position())
                .sub(hits.get(0).inScene(photograph.studio().sceneFromCamera()).position());

        assertThat(hits.get(1).object().description()).isEqualTo("wall");
        assertThat(Math.toDegrees(Math.atan2(way.x, -way.z))).isCloseTo(expected, within(1e-4));
        if (ratio > 0) {
            assertThat(hits.get(1).rest().dopplerFactor()).isCloseTo(ratio, within(1e-9));
        }
    }

    /** Speeds of light in water that flows: 0.857143 with the flow, 0.580645 against it. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.857143", "-0.3, 0.580645"})
    void waterDragsLight(double speed, double expected) {
        Moving water = new Moving(
                "water",
                // light that comes from ahead runs along -z
                Velocity.of(0, 0, -speed),
                new Vector3d(0, 0, 20),
                0,
                List.of(new Box("water", new Vector3d(-5, -5, -5), new Vector3d(5, 5, 5), new Refractive(4.0 / 3))));
        Photograph photograph =
                new Photograph(studio(List.of(water), List.of(), Photograph.pinhole(FORWARDS, 1, 0), 100));
        List<SampleHistory.Encounter> hits = photograph.trace(50, 50).mainHits();
        double length = hits.get(1)
                .event()
                .position()
                .sub(hits.get(0).event().position(), new Vector3d())
                .length();
        double time = hits.get(0).event().time() - hits.get(1).event().time();

        assertThat(length / time).isCloseTo(expected, within(1e-6));
    }

    /** A sphere of radius 1 with 0.8, 10 away at right angles in its rest frame. */
    @Test
    void movingSphereHasARoundOutline() {
        double own = Math.toRadians(90);
        double axis = Math.toRadians(180 - 37.0082);
        double radius = Math.toRadians(3.45089);
        // where the sphere is in its rest frame: across the motion from the camera, which is at the origin at time 0
        Moving ball = moving(
                0.8, new Vector3d(), new Sphere("ball", new Vector3d(0, 0, 10 * Math.sin(own)), 1, Photograph.WHITE));
        Vector3d centre = new Vector3d(Math.cos(axis), 0, Math.sin(axis));
        Photograph photograph = new Photograph(studio(List.of(ball), List.of(), Photograph.pinhole(centre, 8, 0), 800));
        assertThat(photograph.outline())
                .hasSizeGreaterThan(1000)
                .allSatisfy(
                        place -> assertThat(photograph.cameraDirection(place).angle(centre))
                                .isCloseTo(radius, within(1.5e-4)));
    }

    /** A ball at height 2 with 0.6 below a lamp at height 4: a late shadow, and a fast one. */
    @ParameterizedTest
    @CsvSource({"5, 3, true", "5, 6, false", "-5, -15.75, true"})
    void shadowOfAMovingBallIsLate(double time, double x, boolean dark) {
        Moving ball = moving(0.6, new Vector3d(0, 2, 0), new Sphere("ball", new Vector3d(), 0.05, DULL));
        Plane floor = new Plane("floor", new Vector3d(), new Vector3d(0, 1, 0), DULL);
        LightSource lamp = new PointLight(new Vector3d(0, 4, 0), Colour.WHITE, Colour.BLACK, 1);
        // the camera stands just above the point of the floor
        ThinLensCamera camera =
                at(new Vector3d(x, 0.001, 0), Photograph.pinhole(new Vector3d(0, -1, 0), 1, time + 0.001));
        SampleHistory life = new Photograph(studio(List.of(ball, floor), List.of(lamp), camera, 100)).trace(50, 50);

        assertThat(life.colour().red() == 0).isEqualTo(dark);
    }

    /** A lamp that comes with 0.8 makes a surface 81 times as bright; one that goes 1/81. */
    @ParameterizedTest
    @CsvSource({"0.8, 0.0123457", "-0.8, 81"})
    void searchlightOfALamp(double away, double factor) {
        Plane floor = new Plane("wall", new Vector3d(0, 0, 1), new Vector3d(0, 0, -1), DULL);
        LightSource lamp = new MovingLights(
                Velocity.of(0, 0, -away),
                new Vector3d(0, 0, -1e5 * Math.signum(-away) - 1e6),
                List.of(new PointLight(new Vector3d(), Colour.grey(0.01), Colour.BLACK, 1)));
        Studio studio = studio(List.of(floor), List.of(lamp), Photograph.pinhole(FORWARDS, 1, 0), 100)
                .withColours(ColourLaw.SEARCHLIGHT);

        assertThat(new Photograph(studio).trace(50, 50).colour().red() / 0.01).isCloseTo(factor, within(1e-4 * factor));
    }

    @Test
    void fastestSeenAcross() {
        // 0.95 at cos a = 0.95 to the direction to the camera: gamma b = 3.04243
        double speed = 0.95;
        double angle = Math.acos(speed);
        double distance = 1e5;
        Velocity velocity = Velocity.of(speed * Math.sin(angle), 0, -speed * Math.cos(angle));
        Moving ball = new Moving(
                "ball",
                velocity,
                new Vector3d(0, 0, distance),
                0,
                List.of(new Sphere("", new Vector3d(), 1, Photograph.WHITE)));
        double[] places = new double[2];
        for (int i = 0; i < 2; i++) {
            Photograph photograph = new Photograph(studio(
                    List.of(ball),
                    List.of(),
                    Photograph.pinhole(FORWARDS, Math.toDegrees(100 / distance), distance + 10 * i),
                    1000));
            places[i] = photograph.centroid(0).x * 0.1;
        }

        assertThat((places[1] - places[0]) / 10).isCloseTo(3.04243, within(0.01));
    }
}
