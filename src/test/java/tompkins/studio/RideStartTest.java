package tompkins.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.property.InvalidPropertyException;
import tompkins.shutter.FixedPointSurfaceShutter;
import tompkins.spacetime.Event;
import tompkins.spacetime.Velocity;
import tompkins.trace.RenderPlan;

/** Rides that begin elsewhere than the photograph of their scene. */
class RideStartTest {

    private static final Vector3d PLACE = new Vector3d(1, 2, -30);

    private static Ride ride(Velocity velocity, List<RideLeg> legs) {
        return new Ride("ride", "", PLACE, velocity, 1, legs, List.of());
    }

    /** The event at the lens is found by the plan of the photograph, another way than that by which it was set. */
    @Test
    void theLensIsAtTheStartWhenThePhotographWasTaken() {
        Studio photograph = Studios.lattice()
                .withVelocity(Velocity.of(0.3, 0, 0.8))
                .withCamera(Studio.DEFAULT.camera().withShutter(FixedPointSurfaceShutter.DEFAULT));
        double time = RenderPlan.of(photograph).middleHistory().sceneStart().time();
        for (Velocity velocity : List.of(Velocity.REST, Velocity.of(0, 0.6, 0))) {
            Studio start = ride(velocity, List.of()).start(photograph);
            Event lens = RenderPlan.of(start).middleHistory().sceneStart();
            assertThat(lens.position().distance(PLACE)).isLessThan(1e-9);
            assertThat(lens.time()).isCloseTo(time, within(1e-9));
            assertThat(start.velocity()).isEqualTo(velocity);
            assertThat(start.scene()).isEqualTo(photograph.scene());
        }
    }

    @Test
    void itsLegsFollowFromThere() {
        RideLeg leg = new RideLeg(1, 2, new Vector3d(0, 0, 0.5), 0, 0, 1);
        Studio start = ride(Velocity.REST, List.of(leg)).start(Studios.sphere());
        assertThat(start.ride()).containsExactly(leg);
        RideMoment end = RideMoment.start(start).after(leg, 2);
        // (cosh 1 - 1)/0.5
        assertThat(end.rider().event().position().distance(PLACE.x, PLACE.y, PLACE.z + 2 * (Math.cosh(1) - 1)))
                .isLessThan(1e-9);
    }

    @Test
    void lightMustMove() {
        assertThatThrownBy(() -> new Ride("", "", PLACE, Velocity.REST, 0, List.of(), List.of()))
                .isInstanceOf(InvalidPropertyException.class)
                .hasMessageContaining("lightSpeed");
    }
}
