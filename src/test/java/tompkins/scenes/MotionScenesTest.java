package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.explain.Explanation;
import tompkins.property.Descriptions;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Event;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** The numbers that the scenes of the topic Motion tell in their remarks, measured on their rays. */
class MotionScenesTest {

    private static Studio at(Studio studio, double openingTime) {
        return studio.withCamera(((ThinLensCamera) studio.camera()).withShutter(new AperturePlaneShutter(openingTime)));
    }

    /** What a row of the picture sees, pixel by pixel. */
    private static List<SampleHistory.Encounter> row(Studio studio, double row) {
        RenderPlan plan = RenderPlan.of(studio.withSettings(studio.settings().withSize(2000, 1500)));
        List<SampleHistory.Encounter> seen = new ArrayList<>();
        for (int column = 0; column < 2000; column++) {
            SampleHistory life = SampleHistory.of(plan, column + 0.5, row * 1500, 0, 0);
            if (life != null && life.end() != null) {
                seen.add(life.end());
            }
        }
        return seen;
    }

    private static double width(List<SampleHistory.Encounter> hits, Predicate<SampleHistory.Encounter> which) {
        List<Double> places =
                hits.stream().filter(which).map(hit -> hit.event().x()).toList();
        assertThat(places).hasSizeGreaterThan(5);
        return places.get(places.size() - 1) - places.get(0);
    }

    private static Predicate<SampleHistory.Encounter> named(String name) {
        return hit -> hit.object().description().equals(name);
    }

    private static Predicate<SampleHistory.Encounter> frontOfRod() {
        return named("rod").and(hit -> hit.rest().event().z() < -0.2);
    }

    private static Predicate<SampleHistory.Encounter> onFront() {
        return named("cube").and(hit -> Math.abs(hit.rest().event().z() - 11) < 1e-9);
    }

    private static Predicate<SampleHistory.Encounter> onRearSide() {
        return named("cube").and(hit -> Math.abs(hit.rest().event().x() + 1) < 1e-9);
    }

    /** Front 2/gamma; the far edge of the rear side is farther away, so that its light is as much older. */
    @Test
    void cubeLooksTurned() throws Exception {
        List<SampleHistory.Encounter> hits = row(SceneFiles.read("motion-cube"), 0.5);

        assertThat(width(hits, onFront())).isCloseTo(1.2, within(0.02));
        List<SampleHistory.Encounter> side = hits.stream().filter(onRearSide()).toList();
        Event near = side.get(side.size() - 1).event();
        Event far = side.get(0).event();
        double older =
                near.position().distance(new Vector3d(0, 1, 0)) - far.position().distance(new Vector3d(0, 1, 0));
        assertThat(near.x() - far.x()).isCloseTo(-0.8 * older, within(0.01));
        assertThat(near.x() - far.x()).isBetween(1.6, 1.8);
    }

    /**
     * Where a point that moves with 0.8 along x, and passes x = 0.6 own at time 0, is seen from x = 0 at a time: x =
     * 0.8 t + 0.6 own with the time t that light left it, t = time - sqrt(x^2 + beside^2).
     */
    private static double seenAt(double own, double time, double beside) {
        double arrival = 0.8 * time + 0.6 * own;
        return (arrival - 0.8 * Math.sqrt(arrival * arrival + 0.36 * beside * beside)) / 0.36;
    }

    /** Coming, straight ahead and going, all of the front is seen; the row is that of the middle of the front. */
    @ParameterizedTest
    @CsvSource({"8, 1.483", "11.045, 1.2", "14, 1.039"})
    void cubeIsSeenWhereItsLightSays(double time, double width) throws Exception {
        List<SampleHistory.Encounter> front = row(at(SceneFiles.read("motion-cube"), time), 0.5).stream()
                .filter(onFront())
                .toList();
        double beside = Math.hypot(11, 1);
        double left = seenAt(-1, time, beside);
        double right = seenAt(1, time, beside);

        assertThat(front.get(0).event().x()).isCloseTo(left, within(0.01));
        assertThat(front.get(front.size() - 1).event().x()).isCloseTo(right, within(0.01));
        assertThat(right - left).isCloseTo(width, within(0.01));
    }

    @Test
    void rodFitsAsSeenAndAsMeasured() throws Exception {
        double row = 0.5 + 0.5 * 0.6 / 8 / (0.75 * Math.tan(Math.toRadians(35)));
        Studio seen = SceneFiles.read("motion-barn");
        Studio measured = SceneFiles.read("motion-barn-measured");
        assertThat(measured.view()).isEqualTo(View.MEASURED);

        assertThat(width(row(seen, row), frontOfRod())).isCloseTo(6, within(0.1));
        assertThat(width(row(measured, row), frontOfRod())).isCloseTo(6, within(0.1));
    }

    /**
     * Towards where the rod is at three opening times: from far away it looks sqrt((1 + 0.8)/(1 - 0.8)) = 3 times as
     * long as at rest, in the barn 6, and going 3 times shorter.
     */
    @ParameterizedTest
    @CsvSource({"-100, 30, 0.2", "8.565, 6, 70", "900, 3.333, 0.02"})
    void rodIsSeenAsLongAsTheRemarksSay(double time, double length, double degrees) throws Exception {
        Studio studio = at(SceneFiles.read("motion-barn"), time);
        double beside = Math.hypot(7.75, 0.6);
        Vector3d towards = new Vector3d(seenAt(0, time, beside), -0.6, 7.75);
        Camera turned = Descriptions.with(
                Descriptions.with(studio.camera(), "viewDirection", towards), "horizontalAngleDegrees", degrees);
        List<SampleHistory.Encounter> rod = row(studio.withCamera(turned), 0.5).stream()
                .filter(frontOfRod())
                .toList();
        double[] places =
                rod.stream().mapToDouble(hit -> hit.event().x()).sorted().toArray();
        double left = seenAt(-5, time, beside);
        double right = seenAt(5, time, beside);

        assertThat(places.length).isGreaterThan(100);
        assertThat(places[0]).isCloseTo(left, within(0.02 * length));
        assertThat(places[places.length - 1]).isCloseTo(right, within(0.02 * length));
        assertThat(right - left).isCloseTo(length, within(0.02 * length));
    }

    /** tau = gamma (t - v x) at the place and time of each hit; the front one of two is 0.6 x 2 behind. */
    @Test
    void clocksOfTheUpperRowDisagreeWhenMeasured() throws Exception {
        Studio studio = SceneFiles.read("motion-clocks").withView(View.MEASURED);
        List<SampleHistory.Encounter> clocks = row(at(studio, 0), 0.378).stream()
                .filter(named("clock"))
                .filter(hit -> hit.rest().motion() != null)
                .toList();
        assertThat(clocks).hasSizeGreaterThan(100);
        SampleHistory.Encounter first = clocks.get(0);
        SampleHistory.Encounter last = clocks.get(clocks.size() - 1);
        double own = last.rest().event().x() - first.rest().event().x();
        assertThat(last.rest().clockReading() - first.rest().clockReading()).isCloseTo(-0.6 * own, within(1e-9));
    }

    /** gamma b at the angle of fastest motion, in units of the speed of light, from two pictures 0.01 apart. */
    @Test
    void blobSeemsFasterThanLight() throws Exception {
        Studio studio = SceneFiles.read("motion-superluminal");
        Vector3d place = place(studio, 62);
        double angle = place(studio, 62.01).angle(place);
        assertThat(angle * place.length() / 0.01).isCloseTo(3.04, within(0.1));
    }

    /** Where the middle of the first blob is seen, by the retarded time of its centre. */
    private static Vector3d place(Studio studio, double time) {
        Vector3d velocity = new Vector3d(0.29664, 0, -0.90249);
        Vector3d start = new Vector3d(-8, 0, 60);
        double early = 0;
        double late = time;
        for (int i = 0; i < 200; i++) {
            double middle = (early + late) / 2;
            double arrival =
                    middle + new Vector3d(velocity).mul(middle).add(start).length();
            early = arrival < time ? middle : early;
            late = arrival < time ? late : middle;
        }
        Vector3d place = new Vector3d(velocity).mul(early).add(start);
        double x = 320 * (1 + place.x / place.z / Math.tan(Math.toRadians(22)));
        SampleHistory life = SampleHistory.of(RenderPlan.of(at(studio, time)), x, 240, 0, 0);
        assertThat(life.end().object().description()).isEqualTo("blob");
        // its front is seen as it was up to ten times as much later as it is nearer
        assertThat(life.end().event().position().distance(place)).isLessThan(1.6);
        return place;
    }

    /**
     * Through water of the index n at the speed v: what lies at the angle a from the way is seen at tan a' = sin
     * a/(gamma (cos a + n v)), with the Doppler factor gamma (1 + n v cos a).
     */
    @ParameterizedTest
    @CsvSource({"0.6, 90", "0.6, 45", "0.6, 110", "0.3, 70", "0.72, 120"})
    void aCameraInWaterSeesByTheLightOfTheWater(double speed, double degrees) throws Exception {
        Studio scene = SceneFiles.read("camera-in-water").withVelocity(Velocity.of(0, 0, speed));
        double index = 4.0 / 3;
        double gamma = 1 / Math.sqrt(1 - speed * speed);
        double a = Math.toRadians(degrees);
        double tangent = Math.sin(a) / (gamma * (Math.cos(a) + index * speed));
        double perRadian = 320 / Math.tan(Math.toRadians(57.5));
        SampleHistory life = SampleHistory.of(RenderPlan.of(scene), 320 + perRadian * tangent, 240, 0, 0);
        assertThat(life.sceneDirection().distance(new Vector3d(Math.sin(a), 0, Math.cos(a))))
                .isLessThan(1e-12);
        assertThat(life.sceneDopplerFactor()).isCloseTo(gamma * (1 + index * speed * Math.cos(a)), within(1e-12));
    }

    /** The hoop around the camera, at 45 degrees; it is 0.8 away, and its light came with 0.75. */
    @Test
    void theHoopAroundTheCameraIsSeenAhead() throws Exception {
        RenderPlan plan = RenderPlan.of(SceneFiles.read("camera-in-water"));
        SampleHistory.Encounter seen = SampleHistory.of(plan, 320 + 320 / Math.tan(Math.toRadians(57.5)), 240, 0, 0)
                .end();
        assertThat(seen.object().description()).isEqualTo("hoop around the camera");
        assertThat(seen.event().time()).isCloseTo(-0.8 / 0.75, within(1e-12));
        assertThat(new Explanation(plan).sentences())
                .anyMatch(sentence -> sentence.startsWith("The camera moves through a medium of index 1.333: "));
    }

    /**
     * Where a wall is lit by light that left a lamp of 6504 K at the angle a, it looks as in the light of one that
     * rests and has D times that temperature, D = 1/(gamma (1 - v cos a)).
     */
    @ParameterizedTest
    @ValueSource(ints = {10, 100, 200, 300, 400, 500, 630})
    void aLampThatFliesHasTheTemperatureOfItsShift(int column) {
        SampleHistory life = SampleHistory.of(RenderPlan.of(SceneFiles.read("motion-lamp-colours")), column, 60, 0, 0);
        assertThat(life.end().object().description()).isEqualTo("wall");
        Event lit = life.end().event();
        // |lit - (v s, 0.8, 8)| = t - s, with what lies beside the way of the lamp squared
        double beside = Math.pow(lit.y() - 0.8, 2) + 4;
        double left = lit.x() - 0.6 * lit.time();
        double way = (0.6 * left + Math.sqrt(left * left + 0.64 * beside)) / 0.64;
        double factor = 0.8 / (1 - 0.6 * (left + 0.6 * way) / way);
        Vector3d seen = blackBody(6504 * factor).div(blackBody(6504));

        assertThat(life.colour().red() / life.colour().blue()).isCloseTo(seen.x / seen.z, withinPercentage(2));
        assertThat(life.colour().green() / life.colour().blue()).isCloseTo(seen.y / seen.z, withinPercentage(2));
    }

    /** Linear sRGB, by the fit of Kim et al. (2002) to the chromaticity of black bodies from 2222 to 25000 K. */
    private static Vector3d blackBody(double temperature) {
        double t = 1000 / temperature;
        boolean cool = temperature < 4000;
        double x = cool
                ? 0.179910 + t * (0.8776956 - t * (0.2343589 + t * 0.2661239))
                : 0.240390 + t * (0.2226347 + t * (2.1070379 - t * 3.0258469));
        double y = cool
                ? -0.16748867 + x * (2.09137015 - x * (1.37418593 + x * 0.9549476))
                : -0.37001483 + x * (3.75112997 - x * (5.87338670 - x * 3.0817580));
        return new Vector3d(x / y, 1, (1 - x - y) / y)
                .mul(new Matrix3d(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570));
    }

    /** With paint that had the shift of the lamp, the red ball ahead would be seen by its infrared, and be pale. */
    @Test
    void paintInTheLightOfAFlyingLampStaysAsItIs() {
        RenderPlan plan = RenderPlan.of(SceneFiles.read("motion-lamp-colours"));
        SampleHistory ahead = SampleHistory.of(plan, 545, 300, 0, 0);

        assertThat(ahead.end().object().description()).isEqualTo("red ball");
        assertThat(ahead.colour().red()).isGreaterThan(2 * ahead.colour().blue());
    }
}
