package tompkins.studio;

import java.util.List;
import tompkins.camera.Camera;
import tompkins.camera.ThinLensCamera;
import tompkins.lesson.LessonPlan;
import tompkins.lesson.NoLesson;
import tompkins.light.AmbientLight;
import tompkins.light.ColourLaw;
import tompkins.light.LightSource;
import tompkins.light.Metering;
import tompkins.light.MovingLights;
import tompkins.light.PointLight;
import tompkins.property.Descriptions;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.SpaceTimeTransformation;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;

/** Everything that makes a photograph. Immutable; one scene file holds one studio. */
@Meaning("Everything that makes a photograph")
public record Studio(
        @Meaning("Title of the photograph") String title,

        @Meaning("Heading under which the window's menu of examples lists the scene")
        String topic,

        @Meaning(value = "What there is to see", prose = true)
        String remarks,

        @Meaning("The objects of the scene, at rest in its frame unless they are Moving")
        List<SceneObject> scene,

        @Meaning(
                "The objects that move with the camera, such as windows in front of the lens; seen before everything in the scene")
        List<SceneObject> cameraFrame,

        @Meaning("The light sources, which light all frames, at rest in that of the scene unless they are Moving")
        List<LightSource> lights,

        @Meaning("What is seen where there is no object") Background background,
        @Meaning("The camera, described in its rest frame") Camera camera,

        @Meaning(value = "Velocity of the camera in the scene frame", unit = "c")
        Velocity velocity,

        @Meaning("The law by which the velocity changes what the camera sees")
        TransformationLaw transformation,

        @Meaning(
                "Whether the picture shows what the camera sees, or where things are at one time of its frame, measured"
                        + " without the travel time of light")
        View view,

        @Meaning("What the motion does to brightness and colours, under the Lorentz transformation")
        ColourLaw colours,

        @Meaning("How the photograph is exposed where motion changes the brightness of the scene")
        Metering metering,

        @Meaning("Size and quality of the picture") RenderSettings settings,

        @Meaning("A ride with the camera that begins with this photograph, in legs that follow each other")
        List<RideLeg> ride,

        @Meaning("Rides that begin elsewhere; the window offers them, and begins with the first")
        List<Ride> rides,

        @Meaning("What the scene teaches, step by step") LessonPlan lesson,

        @Meaning("Where text editors find the schema of scene files; they complete keys with it and show mistakes")
        String $schema) {

    /** An empty scene, lit as in the paper, and its camera at rest. */
    public static final Studio DEFAULT = new Studio(
            "Untitled",
            "Other scenes",
            "",
            List.of(),
            List.of(),
            List.of(AmbientLight.DEFAULT, PointLight.DEFAULT),
            UniformBackground.DEFAULT,
            ThinLensCamera.DEFAULT,
            Velocity.REST,
            TransformationLaw.LORENTZ,
            View.SEEN,
            ColourLaw.UNCHANGED,
            Metering.MIDDLE,
            RenderSettings.DEFAULT,
            List.of(),
            List.of(),
            NoLesson.DEFAULT,
            "");

    /** Checks that the camera is not too fast for a picture, and that what goes along with it is at rest there. */
    public Studio {
        scene = Require.list("scene", scene);
        cameraFrame = Require.list("cameraFrame", cameraFrame);
        for (int i = 0; i < cameraFrame.size(); i++) {
            SceneObject.requireAtRest("cameraFrame[" + i + "]", cameraFrame.get(i));
        }
        lights = Require.list("lights", lights);
        Velocity.required("velocity", velocity);
        ride = Require.list("ride", ride);
        rides = Require.list("rides", rides);
    }

    /** The title up to a colon, after which an explanation follows. */
    public String shortTitle() {
        return title.replaceFirst("(?s):.*", "");
    }

    /** Whether another studio holds equal objects and lights. */
    public boolean hasSameObjects(Studio other) {
        return scene.equals(other.scene) && cameraFrame.equals(other.cameraFrame) && lights.equals(other.lights);
    }

    /** The change from the camera frame to the scene frame. */
    public SpaceTimeTransformation sceneFromCamera() {
        return transformation.sceneFromCamera(velocity);
    }

    /** Whether something in the scene moves, an object or a lamp. */
    public boolean hasMotion() {
        return transformation != TransformationLaw.NONE
                && (scene.stream().anyMatch(SceneObject::moves)
                        || lights.stream().anyMatch(MovingLights.class::isInstance));
    }

    /**
     * Whether motion changes brightness and colours. Only relativity says how; the measured view has no light to
     * change, and a camera at rest sees objects at rest as they are.
     */
    public boolean shiftsColours() {
        return colours != ColourLaw.UNCHANGED
                && transformation == TransformationLaw.LORENTZ
                && view == View.SEEN
                && (!velocity.isRest() || hasMotion());
    }

    /** The same studio with another scene. */
    public Studio withScene(List<SceneObject> objects) {
        return Descriptions.with(this, "scene", objects);
    }

    /** The same studio with other objects that move with the camera. */
    public Studio withCameraFrame(List<SceneObject> objects) {
        return Descriptions.with(this, "cameraFrame", objects);
    }

    /** The same studio with another camera. */
    public Studio withCamera(Camera other) {
        return Descriptions.with(this, "camera", other);
    }

    /** The same studio with another velocity of the camera. */
    public Studio withVelocity(Velocity other) {
        return Descriptions.with(this, "velocity", other);
    }

    /** The same studio under another law. */
    public Studio withTransformation(TransformationLaw law) {
        return Descriptions.with(this, "transformation", law);
    }

    /** The same studio in another view. */
    public Studio withView(View other) {
        return Descriptions.with(this, "view", other);
    }

    /** The same studio under another law of colours. */
    public Studio withColours(ColourLaw law) {
        return Descriptions.with(this, "colours", law);
    }

    /** The same studio with other settings of the picture. */
    public Studio withSettings(RenderSettings other) {
        return Descriptions.with(this, "settings", other);
    }

    /** The same studio with another ride that begins with it. */
    public Studio withRide(List<RideLeg> legs) {
        return Descriptions.with(this, "ride", legs);
    }
}
