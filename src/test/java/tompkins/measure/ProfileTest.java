package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.sceneobject.Sphere;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;

class ProfileTest {

    private static final Sphere BALL = new Sphere("", new Vector3d(0, 0, 10), 1, LuminousSurface.DEFAULT);

    /** The edge of a ball of radius 1 in the distance 10 lies at the slope 1/sqrt(99). */
    @Test
    void edgeOfABallIsFoundToAHundredthOfAPixel() {
        RenderPlan plan = RenderPlan.of(Studio.DEFAULT.withScene(List.of(BALL)));

        Profile profile = Profile.between(plan, 320, 240, 620, 240, 3001, () -> true);
        double[] edge = profile.edge(sighting -> sighting.life().colour().red());

        double slope = 1 / Math.sqrt(99);
        assertThat(edge[0]).isCloseTo(320 + 320 * slope / Math.tan(Math.toRadians(10)), within(0.1));
        assertThat(edge[1]).isEqualTo(240);
        assertThat(profile.places()).hasSize(3001);
        assertThat(profile.places().get(3000).x()).isEqualTo(620);
    }

    @Test
    void aProfileThatIsNotWantedAnyMoreEnds() {
        RenderPlan plan = RenderPlan.of(Studio.DEFAULT);
        int[] asked = new int[1];

        assertThat(Profile.between(plan, 0, 0, 9, 9, 10_000, () -> ++asked[0] < 5))
                .isNull();
        assertThat(asked[0]).isEqualTo(5);
    }
}
