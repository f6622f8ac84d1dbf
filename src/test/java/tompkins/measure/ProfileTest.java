package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector2d;
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
