package tompkins.ui.compare;

import org.joml.Vector3d;
import tompkins.light.ColourLaw;
import tompkins.spacetime.TransformationLaw;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.Studio;
import tompkins.studio.View;
import tompkins.ui.model.Shutters;
import tompkins.ui.picture.Comparison;

/**
 * What the photograph is compared with.
 *
 * @param other the kind of the other picture
 * @param shutter the model of the other shutter, if that is what differs
 * @param view how the two are shown
 * @param name name of the other picture
 */
public record Compared(ComparePanel.Other other, Class<?> shutter, Comparison view, String name) {

    /** The photograph alone. */
    public static final Compared NOTHING = new Compared(ComparePanel.Other.NOTHING, null, Comparison.NONE, "");

    /** The studio of the other picture; null if there is none, or if it is the kept one. */
    public Studio studio(Studio now) {
        return switch (other) {
            case NOTHING, KEPT_PICTURE -> null;
            case AT_REST -> FrontWindow.withVelocity(now, Velocity.of(new Vector3d()));
            case GALILEAN_CAMERA -> now.withTransformation(TransformationLaw.GALILEAN);
            case UNCHANGED_COLOURS -> now.withColours(ColourLaw.UNCHANGED);
            case SEEN -> now.withView(View.SEEN);
            case MEASURED -> now.withView(View.MEASURED);
            case OTHER_SHUTTER -> now.camera().accepts(shutter) ? Shutters.replaced(now, shutter) : now;
        };
    }
}
