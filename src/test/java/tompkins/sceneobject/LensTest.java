package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.Studio;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Refractive;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

class LensTest {

    private static final double INDEX = 1.5;
    private static final Vector3dc MIDDLE = new Vector3d(0, 0, 10);
    private static final Vector3dc TO_CAMERA = new Vector3d(0, 0, -1);
    private static final double WALL = 11;

    private static Lens lens(double edge, double front, double back) {
        return new Lens("lens", MIDDLE, TO_CAMERA, 1, edge, front, back, new Refractive(INDEX));
    }

    /** The main branch of a ray from a point into a lens and on to a wall. */
    private static List<SampleHistory.Encounter> ray(Lens lens, double x, double pixelX, double pixelY) {
        Plane wall = new Plane("wall", new Vector3d(0, 0, WALL), TO_CAMERA, ColouredSurface.DEFAULT);
        Studio studio = Studio.DEFAULT
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "position", new Vector3d(x, 0, 0)))
                .withSettings(Studio.DEFAULT.settings().withSize(400, 300))
                .withScene(List.of(lens, wall));
        return SampleHistory.of(RenderPlan.of(studio), pixelX, pixelY, 0, 0).mainHits();
    }

    /**
     * The lensmaker's equation: a ray at the height h, parallel to the axis, leaves at an angle with the tangent h/f,
     * but for a part h^2 of it.
     */
    @ParameterizedTest
    @CsvSource({"0, 0.5, 0.5", "0, 0.3, 0", "0.1, 0, 0.7", "0.1, -0.8, 0.9", "0.4, -0.3, -0.2", "0, 1, 1"})
    void bringsParallelRaysToItsFocus(double edge, double front, double back) {
        double height = 1e-4;
        List<SampleHistory.Encounter> hits = ray(lens(edge, front, back), height, 200, 150);
        assertThat(hits).hasSize(3);
        Vector3d out = hits.get(1).event().position();
        Vector3d wall = hits.get(2).event().position();
        double power = (out.x - wall.x) / (wall.z - out.z) / height;

        double thickness = edge + sagitta(front) + sagitta(back);
        double expected = (INDEX - 1) * (front + back - (INDEX - 1) * thickness * front * back / INDEX);
        assertThat(power).isCloseTo(expected, within(1e-7));
    }

    /** Of a circle that goes through the rim. */
    private static double sagitta(double curvature) {
        return curvature == 0 ? 0 : 1 / curvature - Math.signum(curvature) * Math.sqrt(1 / (curvature * curvature) - 1);
    }

    @Test
    void refusesFacesThatMeet() {
        assertThatThrownBy(() -> lens(0.1, -0.5, 0))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("edgeThickness must be above 0.26794")
                .hasMessageContaining("was 0.1");
        assertThatThrownBy(() -> lens(0, 0, 0)).hasMessageContaining("edgeThickness must be above 0,");
        assertThatThrownBy(() -> lens(0, 1.01, 0))
                .hasMessageContaining("frontCurvature must be from -1 to 1, was 1.01");
        assertThat(lens(0.27, -0.5, 0).edgeThickness()).isEqualTo(0.27);
    }
}
