package tompkins.ui.editor;

import java.util.List;
import org.joml.Vector3dc;
import tompkins.measure.Projection;
import tompkins.measure.SceneShapes;
import tompkins.sceneobject.SceneObject;
import tompkins.spacetime.FrameMotion;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.world.SeenFrame;

/** Finds out whether an object of the scene lies within the edges of the picture; what hides it does not count. */
final class InPicture {

    private InPicture() {}

    /** Whether the middle of one part of an object lies in the picture, or of a part that has no middle. */
    static boolean shows(Studio studio, SceneObject object) {
        RenderPlan alone = RenderPlan.of(studio.withScene(List.of(object)));
        SceneShapes shapes = SceneShapes.of(alone.world().frames());
        Projection projection = Projection.of(studio);
        return shapes.objects().isEmpty()
                || shapes.objects().stream().anyMatch(part -> shows(projection, part.motion(), part.middle()));
    }

    private static boolean shows(Projection projection, FrameMotion motion, Vector3dc point) {
        return projection.shows(projection.position(new SeenFrame(projection.studio(), motion), point));
    }
}
