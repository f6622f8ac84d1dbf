package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.BoxPrimitive;
import tompkins.primitive.Placement;
import tompkins.property.InvalidPropertyException;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** A box along the axes. Coordinates: from 0 to 1 across each face, to the right and up seen from outside. */
@Meaning("A box along the axes; u and v run from 0 to 1 across each face, to the right and up seen from outside")
public record Box(
        @Meaning("Name of the object") String description,

        @Meaning(value = "The corner with the smallest coordinates", unit = "length", place = true)
        Vector3dc from,

        @Meaning(value = "The corner with the largest coordinates", unit = "length", place = true)
        Vector3dc to,

        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** A cube of side 2 in front of the camera. */
    public static final Box DEFAULT =
            new Box("box", new Vector3d(-1, -1, 9), new Vector3d(1, 1, 11), ColouredSurface.DEFAULT);

    /** Checks all values; each coordinate of {@code to} must be above that of {@code from}. */
    public Box {
        from = Require.finite("from", from);
        to = Require.finite("to", to);
        if (!(to.x() > from.x() && to.y() > from.y() && to.z() > from.z())) {
            throw new InvalidPropertyException(
                    "to", "above " + Require.text(from) + " in every coordinate", Require.text(to));
        }
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(new BoxPrimitive(this, surface, from, to, placement));
    }
}
