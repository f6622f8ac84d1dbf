package tompkins.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** What the remarks of a scene speak of is whole in its picture. */
class ViewTest {

    private static final int WIDTH = 100;
    private static final int HEIGHT = 75;

    /** The pixels from left to right and from top to bottom, both ends included. */
    private record Place(int left, int right, int top, int bottom) {

        static Place of(Studio studio, String object) {
            RenderPlan plan = plan(studio);
            List<Integer> columns = new ArrayList<>();
            List<Integer> rows = new ArrayList<>();
            for (int y = 0; y < HEIGHT; y++) {
                for (int x = 0; x < WIDTH; x++) {
                    SampleHistory.Encounter seen = seen(plan, x, y);
                    if (seen != null && seen.object().description().equals(object)) {
                        columns.add(x);
                        rows.add(y);
                    }
                }
            }
            assertThat(columns).as("pixels of the %s", object).isNotEmpty();
            Place place = new Place(smallest(columns), largest(columns), smallest(rows), largest(rows));
            assertThat(place.left > 0 && place.right < WIDTH - 1 && place.top > 0 && place.bottom < HEIGHT - 1)
                    .as("the %s is whole: %s", object, place)
                    .isTrue();
            return place;
        }

        private static int smallest(List<Integer> numbers) {
            return numbers.stream().mapToInt(Integer::intValue).min().orElseThrow();
        }

        private static int largest(List<Integer> numbers) {
            return numbers.stream().mapToInt(Integer::intValue).max().orElseThrow();
        }

        int width() {
            return right - left + 1;
        }

        int height() {
            return bottom - top + 1;
        }

        double middle() {
            return (left + right + 1) / 2.0;
        }
    }

    /** From rest upwards in the direction that the scene gives, as the slider for the speed goes. */
    @ParameterizedTest
    @CsvSource({"object-box, cube", "object-sphere, ball", "terrell-cube, cube"})
    void staysInTheMiddleAtEverySpeed(String scene, String object) {
        Studio studio = SceneFiles.read(scene);
        assertThat(studio.velocity().given().x()).isPositive();
        Place resting = Place.of(atSpeed(studio, 0), object);
        for (double speed : new double[] {0.3, 0.8, 0.99}) {
            Place place = Place.of(atSpeed(studio, speed), object);
            assertThat(place.middle()).as("middle at %s", speed).isCloseTo(WIDTH / 2.0, within(0.04 * WIDTH));
            assertThat(place.height()).as("height at %s", speed).isCloseTo(resting.height(), within(1));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.6, 0.9, 0.99})
    void ballStaysAsWideAsItIsHigh(double speed) {
        Place ball = Place.of(atSpeed(SceneFiles.read("object-sphere"), speed), "ball");
        assertThat(ball.width()).isCloseTo(ball.height(), within(1));
    }

    /**
     * Penrose: a cap of the sky with the area of the ball reaches as far as the ball itself. A shortened one would
     * reach farther.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 0.8})
    void fiveBallsAreWholeAndRound(double speed) {
        Studio studio = atSpeed(SceneFiles.read("penrose-sphere"), speed);
        RenderPlan plan = plan(studio);
        Vector3d ahead = new Vector3d(0, 0, 1);
        double areaAhead = Math.pow(2 * Math.tan(Math.toRadians(30)) / WIDTH, 2);
        for (int ball = 1; ball <= 5; ball++) {
            String name = "ball " + ball;
            Place place = Place.of(studio, name);
            List<Vector3d> directions = new ArrayList<>();
            Vector3d centre = new Vector3d();
            double area = 0;
            for (int y = place.top; y <= place.bottom; y++) {
                for (int x = place.left; x <= place.right; x++) {
                    SampleHistory ray = SampleHistory.of(plan, x + 0.5, y + 0.5, 0, 0);
                    if (!ray.hits().isEmpty()
                            && ray.hits().get(0).object().description().equals(name)) {
                        Vector3d direction = new Vector3d(ray.cameraDirection());
                        double pixel = areaAhead * Math.pow(direction.dot(ahead), 3);
                        directions.add(direction);
                        centre.fma(pixel, direction);
                        area += pixel;
                    }
                }
            }
            double radius = Math.acos(1 - area / (2 * Math.PI));
            double reach = directions.stream().mapToDouble(centre::angle).max().orElseThrow();
            assertThat(reach / radius).as("%s at %s", name, speed).isBetween(0.93, 1.07);
        }
    }

    /**
     * Terrell: a cube far away looks turned by the angle whose sine is beta; nearer, the rear side is a little
     * narrower.
     */
    @ParameterizedTest
    @CsvSource({"object-box, 0", "object-box, 0.9", "terrell-cube, 0", "terrell-cube, 0.6", "terrell-cube, 0.8"})
    void cubeLooksTurned(String scene, double speed) {
        Studio studio = SceneFiles.read(scene);
        double resting = Place.of(atSpeed(studio, 0), "cube").width();
        RenderPlan plan = plan(atSpeed(studio, speed));
        List<Vector3d> row = IntStream.range(0, WIDTH)
                .mapToObj(x -> seen(plan, x, HEIGHT / 2))
                .filter(seen -> seen != null && seen.object().description().equals("cube"))
                .map(seen -> seen.event().position())
                .toList();
        long rear = row.stream().filter(hit -> Math.abs(hit.x() - 1) < 1e-9).count();
        double front = row.size() - rear;
        assertThat(rear / resting).as("share of the rear side").isCloseTo(speed, within(0.14));
        assertThat(front / resting).as("share of the front").isCloseTo(Math.sqrt(1 - speed * speed), within(0.1));
    }

    @ParameterizedTest
    @ValueSource(strings = {"surface-lorentz-window", "surface-galileo-window"})
    void windowCoversTheRightHalf(String scene) {
        RenderPlan plan = plan(SceneFiles.read(scene));
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                SampleHistory.Encounter seen = seen(plan, x, y);
                assertThat(seen != null && seen.object().description().equals("window"))
                        .as("at %d, %d", x, y)
                        .isEqualTo(x >= WIDTH / 2);
            }
        }
    }

    private static Studio atSpeed(Studio studio, double speed) {
        return studio.withVelocity(
                Velocity.of(SpeedScale.BETA, speed, studio.velocity().given()));
    }

    private static RenderPlan plan(Studio studio) {
        return RenderPlan.of(studio.withSettings(studio.settings().withSize(WIDTH, HEIGHT)));
    }

    /** What a pixel shows, or null. */
    private static SampleHistory.Encounter seen(RenderPlan plan, int x, int y) {
        List<SampleHistory.Encounter> hits =
                SampleHistory.of(plan, x + 0.5, y + 0.5, 0, 0).hits();
        return hits.isEmpty() ? null : hits.get(0);
    }
}
