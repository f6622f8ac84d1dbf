package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector2d;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.studio.UniformBackground;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

class ProfileTest {

    private static final Sphere BALL = new Sphere("", new Vector3d(0, 0, 10), 1, LuminousSurface.DEFAULT);

    /** The edge of a ball of radius 1 in the distance 10 lies at the slope 1/sqrt(99). */
    @Test
    void edgeOfABallIsFoundToTheLastDigits() {
        RenderPlan plan = RenderPlan.of(Studio.DEFAULT.withScene(List.of(BALL)));

        List<Sighting> profile = Sighting.along(plan, new Vector2d(320, 240), new Vector2d(620, 240), () -> true);
        Vector2dc edge = new Edges(plan).largestStep(profile).orElseThrow();

        double slope = 1 / Math.sqrt(99);
        assertThat(edge.x()).isCloseTo(320 + 320 * slope / Math.tan(Math.toRadians(10)), within(1e-6));
        assertThat(edge.y()).isEqualTo(240);
        assertThat(profile).hasSize(301);
        assertThat(profile.get(300).x()).isEqualTo(620);
    }

    /** Two balls, one in front of a brighter one: the larger step counts, not the first. */
    @Test
    void theLargestStepIsTheEdge() {
        Sphere grey = new Sphere("", new Vector3d(-1.5, 0, 10), 0.2, new LuminousSurface(Colour.grey(0.6), true));
        RenderPlan plan = RenderPlan.of(Descriptions.with(
                        Studio.DEFAULT, "background", new UniformBackground(Colour.grey(0.5)))
                .withScene(List.of(
                        grey,
                        new Sphere("", new Vector3d(1.5, 0, 10), 0.2, new LuminousSurface(Colour.grey(0), true)))));

        List<Sighting> across = Sighting.along(plan, new Vector2d(0, 240), new Vector2d(640, 240), () -> true);

        double towards = Math.asin(0.2 / Math.hypot(1.5, 10));
        double slope = Math.tan(Math.atan(0.15) - towards);
        assertThat(new Edges(plan).largestStep(across).orElseThrow().x())
                .isCloseTo(320 + 320 * slope / Math.tan(Math.toRadians(10)), within(1e-6));
    }

    @Test
    void aProfileThatIsNotWantedAnyMoreEnds() {
        RenderPlan plan = RenderPlan.of(Studio.DEFAULT);
        int[] asked = new int[1];

        assertThat(Sighting.along(plan, new Vector2d(0, 0), new Vector2d(9, 9), () -> ++asked[0] < 5))
                .isNull();
        assertThat(asked[0]).isEqualTo(5);
    }
}
