package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;

/** The axes of a window in its surface. */
class WindowAxesTest {

    private static final double SMALL = 1e-15;

    private static Hit hit(SurfaceCoordinates coordinates) {
        Ray ray = Ray.from(0, 0, 0, 0, 0, 1, 0);
        return Hit.blank().set(ray, 5, 0, 0, -1, null, 0, coordinates);
    }

    /** With spans (2, 0, 0) and (1, 2, 0), u is (x - y/2)/2 and v is y/2. */
    @Test
    void skewPiecesHaveAxesAlongTheirSecondSpan() {
        Hit skew = hit(new SurfaceCoordinates(0.5, 0.5, 0.5, -0.25, 0, 0, 0.5, 0));
        assertIs(WindowAxes.SURFACE.inFrame(new Vector3d(1, 0, 0), skew), new Vector3d(2, -1, 0).normalize());
        assertIs(WindowAxes.SURFACE.inFrame(new Vector3d(0, 1, 0), skew), new Vector3d(1, 2, 0).normalize());
        assertIs(WindowAxes.SURFACE.inFrame(new Vector3d(0, 0, 1), skew), new Vector3d(0, 0, -1));
    }

    /** As of a piece whose sides are nearly parallel. */
    @Test
    void roundingLeavesAxesEverywhere() {
        Hit along = hit(new SurfaceCoordinates(0.5, 1, 0.5, 0, 0, 0, 0, 0));
        assertIs(WindowAxes.SURFACE.inFrame(new Vector3d(1, 0, 0), along), new Vector3d(1, 0, 0));
        // to the right and up for one who looks at the surface
        assertIs(WindowAxes.SURFACE.inFrame(new Vector3d(0, 1, 0), along), new Vector3d(0, 1, 0));
        Vector3dc other = WindowAxes.SURFACE.inFrame(
                new Vector3d(0.6, 0.8, 0), hit(new SurfaceCoordinates(0.5, 1, 0, 0, 0, 0, 0, 0)));
        assertThat(other.length()).isCloseTo(1, within(SMALL));
        assertThat(other.z()).isZero();
    }

    private static void assertIs(Vector3dc found, Vector3dc expected) {
        assertThat(found.distance(expected)).as("%s", found).isLessThan(SMALL);
    }
}
