package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

class FitsTest {

    /** The Penrose sphere of 3.4509 degrees, 37.0082 degrees off the motion, from eight edges in a traced picture. */
    @Test
    void circleThroughTracedEdgesIsTheOutlineOfTheSphere() {
        Studio studio = Studio.DEFAULT
                .withCamera(Descriptions.with(
                        ThinLensCamera.DEFAULT,
                        "viewDirection",
                        new Vector3d(Math.sin(Math.toRadians(37)), 0, Math.cos(Math.toRadians(37)))))
                .withVelocity(Velocity.of(0, 0, 0.8))
                .withScene(List.of(new Sphere("", new Vector3d(10, 0, 0), 1, LuminousSurface.DEFAULT)));
        RenderPlan plan = RenderPlan.of(studio);
        List<Vector3d> edges = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            edges.add(new Vector3d(edge(plan, i * Math.PI / 4)));
        }

        CircleFit fit = CircleFit.of(edges);

        assertThat(Math.toDegrees(fit.circle().halfAngle())).isCloseTo(3.4509, within(5e-5));
        assertThat(Math.toDegrees(Angles.between(fit.circle().axis(), new Vector3d(0, 0, 1))))
                .isCloseTo(37.0082, within(5e-5));
        assertThat(fit.residual() * Angles.ARC_MINUTES).isLessThan(1e-6);
    }

    /** The direction at which a way from the middle of the picture leaves the sphere. */
    private static Vector3d edge(RenderPlan plan, double turn) {
        double inside = 0;
        double outside = 230;
        for (int i = 0; i < 60; i++) {
            double middle = (inside + outside) / 2;
            boolean hit = Sighting.of(plan, 320 + middle * Math.cos(turn), 240 + middle * Math.sin(turn))
                            .hit()
                    != null;
            inside = hit ? middle : inside;
            outside = hit ? outside : middle;
        }
        return new Vector3d(plan.chiefDirection(320 + inside * Math.cos(turn), 240 + inside * Math.sin(turn)));
    }

    /** Four points that lie by one angle inside and outside of a circle in turns: that angle is the residual. */
    @Test
    void residualIsTheMissOfThePoints() {
        List<Vector3d> points = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            double angle = 0.1 + (i % 2 == 0 ? 1e-4 : -1e-4);
            double turn = i * Math.PI / 4;
            points.add(
                    new Vector3d(Math.sin(angle) * Math.cos(turn), Math.sin(angle) * Math.sin(turn), Math.cos(angle)));
        }

        CircleFit fit = CircleFit.of(points);

        assertThat(fit.circle().halfAngle()).isCloseTo(0.1, within(1e-9));
        assertThat(fit.residual()).isCloseTo(1e-4, within(1e-9));
    }

    @Test
    void straightLinesOfAPictureFitAGreatCircle() {
        Projection projection = Projection.of(Studio.DEFAULT);
        List<Vector3d> points = new ArrayList<>();
        for (int i = 0; i <= 10; i++) {
            points.add(new Vector3d(projection.direction(20 + 60 * i, 40 + 30 * i)));
        }
        assertThat(LineFit.of(points).worst()).isLessThan(1e-12);

        double pixel = projection.pixelAngle(320, 190);
        points.set(5, new Vector3d(projection.direction(320, 200)));

        // 10 pixels down are 10 cos(atan(1/2)) away from a line of slope 1/2; 10/11 of it stay in a fit of 11 points
        assertThat(LineFit.of(points).worst() / pixel).isCloseTo(10 / 1.25 * Math.sqrt(1.25) * 10 / 11, within(0.05));
    }

    @Test
    void pointsThatTellNothingAreRefused() {
        Vector3d one = new Vector3d(0, 0, 1);
        assertThatThrownBy(() -> CircleFit.of(List.of(one, new Vector3d(0, 1, 0))))
                .isInstanceOf(ArithmeticException.class)
                .hasMessage("a circle needs 3 points or more, not 2");
        assertThatThrownBy(() -> CircleFit.of(List.of(one, one, one))).hasMessageContaining("must not coincide");
        assertThatThrownBy(() -> LineFit.of(List.of(one))).hasMessage("a line needs 2 points or more, not 1");
        assertThatThrownBy(() -> LineFit.of(List.of(one, one))).hasMessageContaining("must not coincide");
    }
}
