package tompkins.ray;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RayPacketTest {

    private static Ray fromCamera() {
        Ray ray = Ray.from(1, 2, 3, 0, 0.6, 0.8, 7);
        ray.spread = 0.01;
        return ray;
    }

    @Test
    void rayComesOutAsItWentIn() {
        RayPacket rays = new RayPacket(2);
        rays.begin(2);
        Ray mirrored = Ray.blank()
                .setInFrame(fromCamera(), 4, 5, 6, 1, 0, 0, 8, 1.5, 0.25, 0.25)
                .bent(Hit.blank().set(fromCamera(), 2, 0, 0, 1, null, 3, null), 0, 1, 0, 0.5);

        rays.set(1, mirrored);

        assertThat(rays.ray(1))
                .usingRecursiveComparison()
                .ignoringFields("part")
                .isEqualTo(mirrored);
        assertThat(rays.ray(1).part).as("it starts on nothing").isZero();
    }

    /** As of a ray that leaves tiled glass before the lens, while its neighbours have yet to be followed. */
    @Test
    void aRayInAMediumLeavesTheOthersInVacuum() {
        RayPacket rays = new RayPacket(3);
        rays.begin(3);
        Medium glass = new Medium(1.5, 0, null);
        rays.set(0, fromCamera());
        rays.set(1, fromCamera().in(glass));

        assertThat(rays.ray(0).medium).isNull();
        assertThat(rays.ray(1).medium).isSameAs(glass);
        assertThat(rays.ray(2).medium).isNull();
        assertThat(rays.isInOneMedium()).isFalse();
    }

    @Test
    void keptRaysKnowTheirSamples() {
        RayPacket rays = new RayPacket(3);
        rays.begin(3);
        for (int i = 0; i < 3; i++) {
            rays.set(i, Ray.from(i, 0, 0, 0, 0, 1, 0));
        }

        rays.move(2, 1);
        rays.keep(2);

        assertThat(rays.count()).isEqualTo(2);
        assertThat(rays.sample(0)).isZero();
        assertThat(rays.sample(1)).isEqualTo(2);
        assertThat(rays.ray(1).x).isEqualTo(2);
    }
}
