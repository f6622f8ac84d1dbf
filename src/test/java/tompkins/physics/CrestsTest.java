package tompkins.physics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.TestRun;
import tompkins.camera.ThinLensCamera;
import tompkins.fuzz.RandomStudio;
import tompkins.ray.Colour;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Lighting;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.LuminousSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.surface.Surface;

/** Frequencies against counted crests, in vacuum, behind mirrors and in media, all of which may move. */
class CrestsTest {

    private static final double ALLOWED = 2e-6;

    /** At higher speeds the steps between neighbouring rays are too coarse. */
    private static final double MOST_GAMMA = 10;

    private static List<CrestCount.Counted> counted(Studio studio) {
        CrestCount crests = new CrestCount(studio);
        List<CrestCount.Counted> counted = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            counted.addAll(crests.at(2.5 + 2.8 * i, 2.1 + 1.9 * i));
        }
        return counted;
    }

    private static void assertCounted(List<CrestCount.Counted> counted) {
        assertThat(counted)
                .filteredOn(
                        hit -> !(Math.abs(hit.counted() - hit.told()) < ALLOWED * Math.max(1, Math.abs(hit.told()))))
                .isEmpty();
    }

    /** Scenes that nobody would build, photographed through a pinhole. */
    @Test
    void randomStudiosTellCountedFrequencies() {
        List<CrestCount.Counted> all = new ArrayList<>();
        for (int seed = 0; seed < TestRun.cases(50, 150); seed++) {
            Studio random = Lighting.of(RandomStudio.of(seed, 0.8), List.of());
            // image points are elsewhere when the camera is
            if (random.scene().toString().contains("ImagePointGrid")) {
                continue;
            }
            boolean isFast = random.velocity().gamma() > MOST_GAMMA;
            SplittableRandom motions = new SplittableRandom(seed);
            all.addAll(counted(random.withScene(random.scene().stream()
                            .map(object -> motions.nextBoolean() ? object : moving(motions, new Vector3d(), object))
                            .toList())
                    .withTransformation(TransformationLaw.LORENTZ)
                    .withView(View.SEEN)
                    .withVelocity(isFast ? Velocity.of(0.3, 0.5, -0.2) : random.velocity())
                    .withCamera(pinhole(0.3 * seed))));
        }
        all.removeIf(hit ->
                hit.hit().rest().motion() != null && hit.hit().rest().motion().gamma() > MOST_GAMMA);

        assertCounted(all);
        assertThat(all).hasSizeGreaterThan(TestRun.cases(40, 120));
        assertThat(all).filteredOn(hit -> hit.hit().movesByItself()).hasSizeGreaterThan(TestRun.cases(20, 60));
    }

    private static ThinLensCamera pinhole(double time) {
        return Photograph.pinhole(new Vector3d(0.1, -0.2, 1), 60, time);
    }

    /** A camera flies in a ball of glass, in which mirrors, other glass and dull things fly about. */
    @Test
    void crestsAreCountedInMovingMedia() {
        List<CrestCount.Counted> all = new ArrayList<>();
        for (int seed = 0; seed < TestRun.cases(20, 60); seed++) {
            all.addAll(counted(media(new SplittableRandom(seed))));
        }

        assertCounted(all);
        assertThat(all).hasSizeGreaterThan(TestRun.cases(150, 500));
        assertThat(all)
                .filteredOn(hit -> hit.hit().surface() instanceof LuminousSurface
                        && hit.hit().movesByItself())
                .hasSizeGreaterThan(TestRun.cases(5, 15));
    }

    private static Studio media(SplittableRandom random) {
        List<SceneObject> scene = new ArrayList<>();
        Refractive glass = new Refractive(1.2 + 0.6 * random.nextDouble());
        scene.add(moving(random, new Vector3d(), new Sphere("water", new Vector3d(), 30, glass)));
        scene.add(new Sphere("shell", new Vector3d(), 100, new LuminousSurface(Colour.WHITE, false)));
        for (int i = 0; i < 5; i++) {
            Surface surface = List.of(
                            new Mirror(1),
                            new Refractive(1.5),
                            new Refractive(0.8),
                            new LuminousSurface(Colour.WHITE, false))
                    .get(random.nextInt(4));
            Vector3d place = vector(random, 6).add(1, -2, 10);
            scene.add(
                    random.nextBoolean()
                            ? moving(random, place, new Sphere("ball", new Vector3d(), 3, surface))
                            : moving(
                                    random,
                                    place,
                                    new Box("box", new Vector3d(-3, -2, -1), new Vector3d(3, 2, 1), surface)));
        }
        return Studios.dark()
                .withScene(scene)
                .withVelocity(Velocity.of(vector(random, 0.4)))
                .withCamera(pinhole(0.5))
                .withSettings(Studio.DEFAULT.settings().withSize(16, 12));
    }

    private static Moving moving(SplittableRandom random, Vector3d place, SceneObject object) {
        return new Moving("", Velocity.of(vector(random, 0.5)), place, 0, List.of(object));
    }

    private static Vector3d vector(SplittableRandom random, double reach) {
        return new Vector3d(
                random.nextDouble(-reach, reach), random.nextDouble(-reach, reach), random.nextDouble(-reach, reach));
    }
}
