package tompkins.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.golden.GoldenRow;
import tompkins.golden.GoldenTable;
import tompkins.math.Vectors;
import tompkins.measure.Angles;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.View;

/** Where the camera looks to see a point, against rays that another program followed with 80 digits. */
class FrameAppearanceTest {

    @ParameterizedTest
    @CsvSource({"m1_hits, SEEN, lorentz, 55", "m1_hits, SEEN, galilean, 4", "m7_measured_hits, MEASURED, lorentz, 40"})
    void cameraLooksWhereTheReferenceRayWent(String table, View view, String law, int least) {
        List<GoldenRow> rows = GoldenTable.rows(table, row -> row.has("hit", "1") && row.has("law", law));

        assertThat(rows).hasSizeGreaterThanOrEqualTo(least);
        for (GoldenRow row : rows) {
            Vector3d beta = row.vector("beta_");
            Vector3d v = row.vector("v");
            Studio studio = Studio.DEFAULT
                    .withVelocity(Velocity.of(beta))
                    .withView(view)
                    .withTransformation(TransformationLaw.valueOf(law.toUpperCase(Locale.ROOT)));
            Vector3d place = row.vector("p");
            FrameMotion motion = new FrameMotion(null, Velocity.of(v), new Event(place.x, place.y, place.z, 0));
            FrameAppearance frame = new FrameAppearance(studio, motion);
            Vector3d o = row.vector("o");
            Event lens = frame.fromCamera(new Event(o.x, o.y, o.z, row.number("ot")));
            Vector3d towards = row.vector("k").sub(lens.position());

            double gamma = studio.velocity().gamma() * motion.velocity().gamma();
            // a point at the distance L in a frame that is passed with gamma is seen to a few roundings, gamma^2 x / L
            double size = 1 + lens.position().length() / towards.length();
            assertThat(Angles.between(frame.look(towards), row.vector("d")))
                    .as("%s, gamma %s", row.id(), gamma)
                    .isLessThan(1e-11 * gamma * gamma * size);
            Event seen = frame.seen(row.vector("k"), new Event(o.x, o.y, o.z, row.number("ot")));
            assertThat(seen.time())
                    .as("%s, gamma %s", row.id(), gamma)
                    .isCloseTo(row.number("ktau"), within(1e-12 * gamma * gamma * (size * towards.length())));
        }
    }

    /** Both fly apart, or towards each other, at 1.2 c: what comes is faster than its light and not seen before. */
    @Test
    void galileanCameraIsNotReachedByWhatItOutruns() {
        Studio studio = Studio.DEFAULT
                .withVelocity(Velocity.of(new Vector3d(0, 0, 0.6)))
                .withTransformation(TransformationLaw.GALILEAN);
        FrameMotion motion = new FrameMotion(null, Velocity.of(new Vector3d(0, 0, -0.6)), Event.ORIGIN);

        FrameAppearance frame = new FrameAppearance(studio, motion);

        assertThat(frame.seen(new Vector3d(0, 0, -4), Event.ORIGIN).time()).isCloseTo(-4 / 2.2, within(1e-15));
        assertThat(frame.seen(new Vector3d(0, 0, 4), Event.ORIGIN)).isNull();
    }

    @Test
    void nestedMotionIsSeenAsTheReferenceSays() {
        List<GoldenRow> rows = GoldenTable.rows("m5_nested");

        assertThat(rows).hasSizeGreaterThan(40);
        for (GoldenRow row : rows) {
            FrameMotion outer = new FrameMotion(null, Velocity.of(row.vector("v1_")), Event.ORIGIN);
            FrameMotion inner = new FrameMotion(outer, Velocity.of(row.vector("v2_")), Event.ORIGIN);
            FrameAppearance frame = new FrameAppearance(Studio.DEFAULT, inner);

            double gamma = outer.velocity().gamma() * inner.velocity().gamma();
            assertThat(Angles.between(frame.look(row.vector("dir2_")), Vectors.unit(row.vector("d_"))))
                    .as(row.id())
                    .isLessThan(1e-14 * (10 + gamma * gamma));
        }
    }
}
