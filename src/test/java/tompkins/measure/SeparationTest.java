package tompkins.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector2dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tompkins.camera.ThinLensCamera;
import tompkins.property.Descriptions;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Event;
import tompkins.spacetime.FrameMotion;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.trace.RenderPlan;
import tompkins.world.FrameAppearance;

class SeparationTest {

    /** Lampa's rod of rest length 1: the ends are seen 2 apart as it comes, and 0.5 apart as it goes. */
    @ParameterizedTest
    @CsvSource({"-0.6, 2", "0.6, 0.5"})
    void rodAlongTheLineOfSightIsSeenLongerOrShorter(double speed, double seen) {
        Velocity velocity = Velocity.of(0, 0, speed);
        Vector3d place = new Vector3d(0, 0, 10);
        // both ends as small balls, a little beside the line of sight
        Sphere near = new Sphere("near", new Vector3d(0.001, 0, 0), 1e-4, LuminousSurface.DEFAULT);
        Sphere far = new Sphere("far", new Vector3d(-0.001, 0, 1), 1e-4, LuminousSurface.DEFAULT);
        Studio studio = Studio.DEFAULT
                .withCamera(Descriptions.with(ThinLensCamera.DEFAULT, "horizontalAngleDegrees", 0.5))
                .withScene(List.of(new Moving("rod", velocity, place, 0, List.of(near, far))));
        FrameAppearance frame = new FrameAppearance(studio, new FrameMotion(null, velocity, new Event(0, 0, 10, 0)));
        Separation rod = between(studio, frame, near.centre(), far.centre());

        assertThat(rod.first().hit().object().description()).isEqualTo("near");
        assertThat(rod.second().hit().object().description()).isEqualTo("far");
        assertThat(rod.inScene().position().length()).isCloseTo(seen, within(1e-3));
        assertThat(rod.inObject().position().length()).isCloseTo(1, within(1e-3));
        // light of the far end left earlier by the way
        assertThat(rod.inScene().time()).isCloseTo(-seen, within(1e-3));
        assertThat(Separation.interval(rod.inObject())).isCloseTo(Separation.interval(rod.inScene()), within(1e-9));
    }

    private static Separation between(Studio studio, FrameAppearance frame, Vector3dc first, Vector3dc second) {
        Projection projection = Projection.of(studio);
        RenderPlan plan = RenderPlan.of(studio);
        Vector2dc from = projection.position(frame, first);
        Vector2dc to = projection.position(frame, second);
        return new Separation(Sighting.of(plan, from.x(), from.y()), Sighting.of(plan, to.x(), to.y()));
    }
}
