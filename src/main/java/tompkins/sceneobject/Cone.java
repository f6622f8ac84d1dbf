package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.ConePrimitive;
import tompkins.primitive.Placement;
import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.surface.ColouredSurface;
import tompkins.surface.Surface;

/** A circular cone. Coordinates: u once around, v from base (0) to tip (1); on the base as on a {@link Disc}. */
@Meaning(
        "A circular cone; u runs once around, to the right seen from outside with the tip above, v from the base (0) to the tip (1)")
public record Cone(
        @Meaning("Name of the object") String description,

        @Meaning(value = "The tip", unit = "length", place = true)
        Vector3dc tip,

        @Meaning(value = "Centre of the base", unit = "length", place = true)
        Vector3dc baseCentre,

        @Meaning(value = "Radius of the base", unit = "length")
        double baseRadius,

        @Meaning("Whether a flat base closes the cone") boolean base,
        @Meaning("What it looks like") Surface surface)
        implements SceneObject {

    /** An upright cone in front of the camera. */
    public static final Cone DEFAULT =
            new Cone("cone", new Vector3d(0, 1, 10), new Vector3d(0, -1, 10), 0.8, true, ColouredSurface.DEFAULT);

    /** Checks all values; tip and base must differ. */
    public Cone {
        tip = Require.finite("tip", tip);
        baseCentre = Require.finite("baseCentre", baseCentre);
        Cylinder.requireDifferent("baseCentre", baseCentre, tip);
        Require.positive("baseRadius", baseRadius);
    }

    @Override
    public double primitiveCount() {
        return base ? 2 : 1;
    }

    @Override
    public boolean isBody() {
        return true;
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        collector.add(new ConePrimitive(this, surface, tip, baseCentre, baseRadius, placement));
        if (base) {
            Vector3d outwards = baseCentre.sub(tip, new Vector3d());
            Disc disc = new Disc(description, baseCentre, outwards, baseRadius, surface);
            collector.add(disc.primitive(this, placement));
        }
    }
}
