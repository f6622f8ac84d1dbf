package tompkins.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Point2D;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.camera.Camera;
import tompkins.sceneobject.Box;
import tompkins.sceneobject.Moving;
import tompkins.sceneobject.Plane;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.studio.View;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Mirror;
import tompkins.surface.Refractive;
import tompkins.trace.RenderPlan;

/** The numbers are closed formulas, the order is that of the ray. */
class RayStoryTest {

    private static List<RayStory.Step> story(Studio studio, double x, double y) {
        return RayStory.of(PixelProbe.read(RenderPlan.of(studio), new Point2D.Double(x, y)));
    }

    private static Stream<String> headings(List<RayStory.Step> story) {
        return story.stream().map(RayStory.Step::heading);
    }

    private static String fact(RayStory.Step step, String label) {
        return step.facts().stream()
                .filter(fact -> fact.label().equals(label))
                .map(RayStory.Fact::value)
                .findFirst()
                .orElse(null);
    }

    /**
     * With beta = 0.8 the camera finds the point of z = 9, t = -9 at gamma (z - beta t) = 27, and light 3 times bluer.
     */
    @Test
    void theEndOfTheRayIsToldInBothFrames() {
        List<RayStory.Step> story = story(Studios.sphere().withVelocity(Velocity.of(0, 0, 0.8)), 32, 24);
        assertThat(headings(story))
                .containsExactly("Pixel 32, 24", "Starts in the camera frame", "Enters the scene frame", "Hits sphere");
        assertThat(fact(story.get(1), "At")).isEqualTo("(0, 0, 0; t\u00a0=\u00a00)");
        assertThat(fact(story.get(2), "Direction")).isEqualTo("(0, 0, 1)");
        assertThat(fact(story.get(2), "Frequency")).isEqualTo("camera/scene 3");
        assertThat(fact(story.get(3), "Distance")).isEqualTo("9");
        assertThat(fact(story.get(3), "In scene")).isEqualTo("(0, 0, 9; t\u00a0=\u00a0-9)");
        assertThat(fact(story.get(3), "In camera")).isEqualTo("(0, 0, 27; t\u00a0=\u00a0-27)");
        assertThat(fact(story.get(3), "Light")).isNull();
    }

    /** The wall z = 9 - 0.8 t is seen at z = 45, t = -45, its own time gamma (t + 0.8 (z - 9)) = -27. */
    @Test
    void whatMovesIsToldInItsOwnFrameToo() {
        Plane wall = new Plane("wall", new Vector3d(1, 2, 0), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        Moving moving = new Moving("moving", Velocity.of(0, 0, -0.8), new Vector3d(0, 0, 9), 100, List.of(wall));
        Studio studio = Studios.sphere().withScene(List.of(moving));
        List<RayStory.Step> story = story(studio, 32, 24);
        RayStory.Step hit = story.get(story.size() - 1);
        assertThat(hit.heading()).isEqualTo("Hits wall");
        assertThat(fact(hit, "Distance")).isEqualTo("45");
        assertThat(fact(hit, "In scene")).isEqualTo("(0, 0, 45; t\u00a0=\u00a0-45)");
        assertThat(fact(hit, "In its own")).startsWith("(0, 0, ");
        assertThat(fact(hit, "Proper time")).isEqualTo("-27");
        assertThat(fact(hit, "Its clocks")).isEqualTo("73");
        assertThat(fact(hit, "Frequency")).isEqualTo("camera/object 3");
        RayStory.Step resting = story(Studios.sphere(), 32, 24).get(3);
        assertThat(fact(resting, "Proper time")).isNull();
    }

    /** At the time 5 of the camera the wall is at z = 9 - 0.8 x 5, whatever light brings of it. */
    @Test
    void whatIsMeasuredHasNoFrequency() {
        Plane wall = new Plane("wall", new Vector3d(), new Vector3d(0, 0, 1), ColouredSurface.DEFAULT);
        Moving moving = new Moving("moving", Velocity.of(0, 0, -0.8), new Vector3d(0, 0, 9), 0, List.of(wall));
        Studio studio = Studios.sphere().withScene(List.of(moving)).withView(View.MEASURED);
        Camera later = studio.camera().withShutter(studio.camera().shutter().openedAt(5));
        List<RayStory.Step> story = story(studio.withCamera(later), 32, 24);
        assertThat(fact(story.get(2), "Frequency")).isEqualTo("none: measured, without light");
        assertThat(fact(story.get(3), "In scene")).isEqualTo("(0, 0, 5; t\u00a0=\u00a05)");
        assertThat(fact(story.get(3), "Frequency")).isNull();
        assertThat(fact(story.get(3), "Its clocks")).isNull();
    }

    @Test
    void aRayThatMeetsNothingEndsInTheBackground() {
        assertThat(headings(story(Studios.sphere(), 0.5, 0.5)))
                .containsExactly(
                        "Pixel 0, 0",
                        "Starts in the camera frame",
                        "Enters the scene frame",
                        "Meets nothing else: the background");
    }

    /** Light that a camera of the speed 0.5 sees coming from ahead in a medium of index 2 has the speed 0 there. */
    @Test
    void lightThatStandsStillInTheSceneIsNotTheBackground() {
        Plane medium = new Plane("medium", new Vector3d(0, 0, -1), new Vector3d(0, 0, -1), new Refractive(2));
        Studio studio = Studios.sphere()
                .withScene(List.of())
                .withVelocity(Velocity.of(0, 0, 0.5))
                .withTransformation(TransformationLaw.GALILEAN)
                .withCameraFrame(List.of(medium));
        assertThat(headings(story(studio, 32, 24)))
                .containsExactly(
                        "Pixel 32, 24",
                        "Starts in the camera frame",
                        "Stands still in the scene: it comes from nowhere and brings no light");
        assertThat(headings(story(studio, 33, 24))).endsWith("Meets nothing else: the background");
    }

    /** What the slab before the lens reflects is told as a weaker branch, and crosses into the scene by itself. */
    @Test
    void weakerBranchesAreMarked() {
        Studio studio = Studios.sphere()
                .withCameraFrame(
                        List.of(new Box("slab", new Vector3d(-5, -5, 2), new Vector3d(5, 5, 3), Refractive.DEFAULT)));
        List<RayStory.Step> story = story(studio, 32, 24);
        assertThat(story.stream().filter(step -> step.branch() == 0).map(RayStory.Step::heading))
                .containsExactly(
                        "Pixel 32, 24",
                        "Starts in the camera frame",
                        "Hits slab",
                        "Hits slab",
                        "Enters the scene frame",
                        "Hits sphere");
        assertThat(story).anyMatch(step -> step.branch() > 0 && step.heading().equals("Hits slab"));
        // in the frame of the slab alone
        assertThat(fact(story.get(2), "In camera")).isEqualTo("(0, 0, 2; t\u00a0=\u00a0-2)");
        assertThat(fact(story.get(2), "In scene")).isNull();
    }

    /** What the mirror sends on meets the wall behind the camera. */
    @Test
    void theShareOfARayThatIsNotTheWholeLightIsTold() {
        Vector3d forwards = new Vector3d(0, 0, 1);
        Studio studio = Studio.DEFAULT.withScene(List.of(
                new Plane("near", new Vector3d(0, 0, 5), forwards, new Mirror(0.25)),
                new Plane("far", new Vector3d(0, 0, -5), forwards, ColouredSurface.DEFAULT)));
        List<RayStory.Step> story = story(studio, 320, 240);
        RayStory.Step last = story.get(story.size() - 1);
        assertThat(last.heading()).isEqualTo("Hits far");
        assertThat(fact(last, "Distance")).isEqualTo("10");
        assertThat(fact(last, "Light")).isEqualTo("at most 0.25");
        assertThat(fact(story.get(story.size() - 2), "Light")).isNull();
    }
}
