package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.camera.Camera;
import tompkins.camera.PixelSampler;
import tompkins.camera.SamplePositions;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.golden.Worst;
import tompkins.property.Descriptions;
import tompkins.ray.RayCounts;
import tompkins.sceneobject.Parallelogram;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.trace.SampleHistory;
import tompkins.trace.SampleTracer;

/**
 * Long exposures of edges in uniform motion against the reference data. An edge that passes the camera with a velocity
 * is photographed as the same edge at rest, by a camera that moves the other way.
 */
class ExposureTest {

    private static final int WIDTH = 200;
    private static final int HEIGHT = 150;
    private static final double SLOPE_PER_PIXEL = 0.01;
    private static final double FAR = 1e5;

    /** The root mean square error of all rows, with several seeds. */
    private static double error(int samples) {
        double sum = 0;
        int count = 0;
        for (Passage passage : Passage.all()) {
            for (long seed = 1; seed <= 4; seed++) {
                double error = passage.mean(samples, seed) - passage.row.number("cover");
                sum += error * error;
                count++;
            }
        }
        return Math.sqrt(sum / count);
    }

    /** The error that as many random samples would have. */
    private static double randomError(int samples) {
        return Math.sqrt(Passage.all().stream()
                .mapToDouble(passage -> passage.row.number("cover"))
                .map(cover -> cover * (1 - cover) / samples)
                .average()
                .orElseThrow());
    }

    /** Both moments of passage come from rays of the program; what lies between them is a share of the exposure. */
    @Test
    void edgesCoverTheSharesOfTheReference() {
        Worst worst = Worst.of(
                GoldenTable.rows("m8_exposure", row -> row.isNumber("cover_centre")),
                row -> Worst.share(
                        row.difference(new Passage(row).coveredShareOfCentre(), "cover_centre"),
                        16 * GoldenTable.U * Math.max(1, row.number("acond_cover_centre"))));
        assertThat(worst).matches(Worst::passes);
    }

    @Test
    void samplesConvergeToTheSharesOfTheReference() {
        assertThat(error(64)).isLessThan(0.3 * randomError(64));
        assertThat(error(1024)).isLessThan(0.18 * randomError(1024));
    }

    /** One exposure of the reference. */
    private static final class Passage {

        private final GoldenRow row;

        /** The sheet that follows the edge, in its rest frame: from here to there along x. */
        private final double from;

        private final double to;

        Passage(GoldenRow row) {
            this.row = row;
            double w = row.number("w");
            double edge = Velocity.of(w, 0, 0).gamma() * row.number("x0");
            double width = row.number("width") > 0 ? row.number("width") : FAR;
            from = w > 0 ? edge - width : edge;
            to = w > 0 ? edge : edge + width;
        }

        static List<Passage> all() {
            return GoldenTable.rows("m8_exposure").stream().map(Passage::new).toList();
        }

        private Photograph of(SceneObject object, Vector3dc view) {
            double w = row.number("w");
            Camera camera =
                    Descriptions.with(Photograph.pinhole(view, 90, row.number("T")), "exposureTime", row.number("E"));
            Velocity opposite = Velocity.of(SpeedScale.BETA, Math.abs(w), new Vector3d(-w, 0, 0));
            return Photograph.of(List.of(object), camera, opposite, WIDTH, HEIGHT);
        }

        /** Where the ray of the pixel's centre meets the plane of the edge, at the beginning or the end. */
        private double placeAt(double moment) {
            Plane plane =
                    new Plane("plane", new Vector3d(0, 0, row.number("Z")), new Vector3d(0, 0, 1), Photograph.WHITE);
            double x = (row.number("X0") + row.number("X1")) / 2;
            double y = (row.number("Y0") + row.number("Y1")) / 2;
            // straight ahead, for a place in the picture would be rounded
            Photograph photograph = of(plane, new Vector3d(x, y, 1));
            SampleHistory life = SampleHistory.of(photograph.plan(), WIDTH / 2.0, HEIGHT / 2.0, 0, 0, moment);
            return life.hits().get(0).event().position().x();
        }

        double coveredShareOfCentre() {
            double first = placeAt(0);
            double last = placeAt(1);
            double covered = Math.min(Math.max(first, last), to) - Math.max(Math.min(first, last), from);
            return Math.max(0, covered) / Math.abs(last - first);
        }

        /** The mean over pixel and exposure with the program's own samples. */
        double mean(int samples, long seed) {
            Parallelogram sheet = new Parallelogram(
                    "sheet",
                    new Vector3d(from, -FAR, row.number("Z")),
                    new Vector3d(to - from, 0, 0),
                    new Vector3d(0, 2 * FAR, 0),
                    Photograph.WHITE);
            SampleTracer tracer = of(sheet, new Vector3d(0, 0, 1)).plan().tracer(new RayCounts());
            PixelSampler sampler = new PixelSampler(seed, false, true);
            SamplePositions place = new SamplePositions(1);
            place.addPixel(0, 0);
            double sum = 0;
            for (int sample = 0; sample < samples; sample++) {
                sampler.choose(place, sample);
                double x = row.number("X0") + place.x[0] * (row.number("X1") - row.number("X0"));
                double y = row.number("Y1") + place.y[0] * (row.number("Y0") - row.number("Y1"));
                sum += tracer.sample(
                                WIDTH / 2.0 + x / SLOPE_PER_PIXEL,
                                HEIGHT / 2.0 - y / SLOPE_PER_PIXEL,
                                0,
                                0,
                                place.moments[0])
                        .red();
            }
            return sum / samples;
        }
    }
}
