package tompkins.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tompkins.Waiting;
import tompkins.image.ToneCurve;
import tompkins.property.Descriptions;
import tompkins.render.Renderer;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.Mirror;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleTracer;
import tompkins.ui.model.Pace;

@Timeout(600)
class RenderControllerTest {

    private final List<Picture> pictures = new CopyOnWriteArrayList<>();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

    @AutoClose
    private final RenderController controller = new RenderController(pictures::add, failures::add);

    private static void await(BooleanSupplier condition) {
        Waiting.until("the pictures", condition);
    }

    private Picture last() {
        return pictures.get(pictures.size() - 1);
    }

    @Test
    void thePictureIsThatOfTheRendererToTheBit() throws InterruptedException {
        Studio studio = Studios.lattice()
                .withSettings(Studio.DEFAULT.settings().withSize(160, 120).withSamples(5));
        show(controller, studio, Pace.HAND);
        await(() -> !pictures.isEmpty() && last().complete());
        try (Renderer renderer = new Renderer(1)) {
            float[] expected = renderer.render(RenderPlan.of(studio)).image().rgb();
            assertThat(last().image().rgb()).isEqualTo(expected);
        }
        assertThat(controller.progress()).isEqualTo(1);
        assertThat(controller.isBusy()).isFalse();
    }

    /** The image of a large picture is made at its end. */
    @Test
    void memoryThatRunsOutAtTheEndIsTold() throws InterruptedException {
        OutOfMemoryError full = new OutOfMemoryError("of this test");
        try (RenderController throwing = new RenderController(
                picture -> {
                    if (picture.complete()) {
                        throw full;
                    }
                },
                failures::add)) {
            show(throwing, Studios.sphere(), Pace.HAND);
            await(() -> !failures.isEmpty());
            assertThat(failures).containsExactly(full);
            assertThat(throwing.isBusy()).isFalse();
        }
    }

    /** All but the newest would need hours. */
    @Test
    void theNewestChangeWins() {
        for (int i = 0; i < 60; i++) {
            show(controller, Studios.slow().withVelocity(Velocity.of(0, 0, i / 100.0)), Pace.HAND);
        }
        show(controller, Studios.sphere(), Pace.HAND);
        await(() -> !pictures.isEmpty() && last().complete());
        assertThat(pictures.stream().filter(Picture::complete).map(Picture::studio))
                .containsExactly(Studios.sphere());
    }

    /** A large picture is still being put together when the small one that was asked for after it is done. */
    @Test
    void aPictureThatWasOvertakenIsNotShownAfterTheNewerOne() throws InterruptedException {
        Studio small = Studios.sphere();
        Studio large = small.withSettings(small.settings().withSize(4000, 3000));
        show(controller, large, Pace.HAND);
        await(() -> controller.progress() == 1);
        show(controller, small, Pace.HAND);
        await(() -> !pictures.isEmpty() && last().studio().equals(small) && last().complete());
        await(() -> Thread.getAllStackTraces().entrySet().stream()
                .filter(thread -> thread.getKey().getName().startsWith("tompkins-"))
                .flatMap(thread -> Stream.of(thread.getValue()))
                .noneMatch(call -> call.getMethodName().equals("deliver")));
        assertThat(last().studio()).isEqualTo(small);
    }

    /** A glimpse is shown once, when it ends; what is asked for without a ride replaces it by the whole picture. */
    @Test
    void onARideThereAreGlimpses() throws InterruptedException {
        Studio studio = Studios.sphere().withSettings(Studio.DEFAULT.settings().withSize(160, 120));
        show(controller, studio, Pace.RIDE);
        await(() -> !pictures.isEmpty() && !controller.isBusy());
        assertThat(pictures).hasSize(1);
        assertThat(last().complete()).isFalse();
        assertThat(last().samples()).isBetween(1 / 64.0, 0.5);
        assertThat(last().error()).isNaN();
        show(controller, studio, Pace.HAND);
        await(() -> last().complete());
        assertThat(last().samples()).isEqualTo(studio.settings().samples());
    }

    /** A picture that has nothing to show is waited for, unless a hand wants another one at once. */
    @Test
    void theAnswerToThrustDoesNotWait() throws InterruptedException {
        Studio mirrors = mirrors(0);
        // its first pass alone takes long
        show(
                controller,
                mirrors.withSettings(Descriptions.with(mirrors.settings(), "maximumDepth", 1_000_000)),
                Pace.RIDE);
        await(() -> isAtWork(SampleTracer.class));
        show(controller, Studios.sphere(), Pace.ANSWER);
        await(() -> !pictures.isEmpty());
        assertThat(pictures.get(0).studio()).isEqualTo(Studios.sphere());
    }

    private static boolean isAtWork(Class<?> worker) {
        return Thread.getAllStackTraces().values().stream()
                .flatMap(Stream::of)
                .anyMatch(call -> call.getClassName().equals(worker.getName()));
    }

    /** In a ball of perfect mirrors a ray goes on until it is given up: even the coarsest pass takes long. */
    @ParameterizedTest
    @EnumSource
    void aPictureIsSeenWhileThingsMoveHoweverLongItTakes(Pace pace) throws InterruptedException {
        int changes = 0;
        while (pictures.isEmpty()) {
            show(controller, mirrors(++changes), pace);
            Thread.sleep(20);
        }
        assertThat(last().complete()).isFalse();
    }

    /** In a ball of perfect mirrors, at a speed that tells pictures from each other. */
    private static Studio mirrors(int number) {
        return Studios.sphere()
                .withScene(List.of(new Sphere("mirror", new Vector3d(0.5, 0, 0), 3, new Mirror(1))))
                .withSettings(new RenderSettings(320, 240, 1, 0, 1, 5_000, ToneCurve.LINEAR))
                .withVelocity(Velocity.of(0, 0, number * 1e-4));
    }

    @Test
    void stopEndsTheWorkAndKeepsThePicture() throws InterruptedException {
        show(controller, Studios.slow(), Pace.HAND);
        await(() -> !pictures.isEmpty());
        controller.stop();
        await(() -> !controller.isBusy());
        int count = pictures.size();
        Thread.sleep(100);
        assertThat(pictures).hasSize(count).noneMatch(Picture::complete);
        controller.stop();
        assertThat(controller.isStopped()).as("stopped twice").isTrue();
        show(controller, Studios.sphere(), Pace.HAND);
        assertThat(controller.isStopped()).isFalse();
        await(() -> last().complete());
        controller.stop();
        assertThat(controller.isStopped()).as("complete before").isFalse();
    }

    @Test
    void aPictureThatIsStillBeingPlannedCanBeStopped() throws InterruptedException {
        show(controller, Studios.sphere().withScene(Collections.nCopies(400_000, Sphere.DEFAULT)), Pace.HAND);
        await(RenderControllerTest::isPlanning);
        assertThat(controller.isBusy()).isTrue();
        assertThat(controller.progress()).isEqualTo(0);
        controller.stop();
        assertThat(isPlanning()).isTrue();
        assertThat(controller.isBusy()).isFalse();
        await(() -> !isPlanning());
        Thread.sleep(100);
        assertThat(controller.isBusy()).isFalse();
        assertThat(pictures).isEmpty();
        show(controller, Studios.sphere(), Pace.HAND);
        await(() -> !pictures.isEmpty() && last().complete());
    }

    /** A hand moves one of many balls: each move comes before the one before it has been planned. */
    @Test
    void aHandSeesPicturesThatTakeLongToPlan() throws InterruptedException {
        List<SceneObject> balls = new ArrayList<>(Collections.nCopies(50_000, Sphere.DEFAULT));
        for (int move = 0; pictures.size() < 3; move++) {
            balls.set(0, new Sphere("moved", new Vector3d(0, 0, 1e-3 * move), 1, Sphere.DEFAULT.surface()));
            show(controller, Studios.sphere().withScene(List.copyOf(balls)), Pace.HAND);
            Thread.sleep(5);
        }
    }

    private static boolean isPlanning() {
        return Thread.getAllStackTraces().entrySet().stream()
                .filter(thread -> thread.getKey().getName().equals("tompkins-plan"))
                .flatMap(thread -> Stream.of(thread.getValue()))
                .anyMatch(call -> call.getClassName().equals(RenderPlan.class.getName()));
    }

    @Test
    void theNextPictureFollowsOneThatFailed() throws InterruptedException {
        Studio group = Studios.sphere().withScene(List.of(nested()));
        show(controller, group, Pace.HAND);
        await(() -> !failures.isEmpty());
        assertThat(controller.isBusy()).isFalse();
        show(controller, Studios.sphere(), Pace.HAND);
        await(() -> !pictures.isEmpty() && last().complete());
    }

    /** Groups in groups, too deep for any stack. */
    private static SceneObject nested() {
        SceneObject object = Sphere.DEFAULT;
        for (int depth = 0; depth < 1_000_000; depth++) {
            object = new Group("group", List.of(object));
        }
        return object;
    }

    private static void show(RenderController controller, Studio studio, Pace pace) {
        controller.show(
                studio,
                new Dimension(studio.settings().width(), studio.settings().height()),
                pace);
    }

    @Test
    void thePictureIsTakenInTheSizeInWhichItIsShown() throws InterruptedException {
        Studio studio = Studios.sphere();
        controller.show(studio, new Dimension(100, 75), Pace.HAND);
        await(() -> !pictures.isEmpty() && last().complete());
        Studio larger = studio.withSettings(studio.settings().withSize(100, 75));
        try (Renderer renderer = new Renderer()) {
            assertThat(last().image().rgb())
                    .isEqualTo(renderer.render(RenderPlan.of(larger)).image().rgb());
        }
        assertThat(last().studio()).isEqualTo(studio);
    }
}
