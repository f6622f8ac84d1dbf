package tompkins.sceneobject;

import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.primitive.Placement;
import tompkins.property.Meaning;
import tompkins.ray.Colour;
import tompkins.ray.PixelPicture;
import tompkins.surface.Clear;
import tompkins.surface.ColouredSurface;
import tompkins.surface.CutOut;
import tompkins.surface.Surface;

/** A parallelogram that is there only where a picture is dark. */
@Meaning("A parallelogram that is there only where a picture is dark; light passes through the rest")
public record Silhouette(
        @Meaning("Name of the object") String description,

        @Meaning(value = "The corner at the lower left of the picture", unit = "length", place = true)
        Vector3dc corner,

        @Meaning(value = "From that corner to the lower right of the picture", unit = "length")
        Vector3dc spanU,

        @Meaning(value = "From that corner to the upper left of the picture", unit = "length")
        Vector3dc spanV,

        @Meaning("The picture file, relative to the scene file")
        PixelPicture picture,

        @Meaning("What the dark parts look like") Surface surface)
        implements SceneObject {

    /** Nothing: the silhouette of a white picture. */
    public static final Silhouette DEFAULT = new Silhouette(
            "silhouette",
            new Vector3d(-0.5, -0.5, 10),
            new Vector3d(1, 0, 0),
            new Vector3d(0, 1, 0),
            PixelPicture.WHITE,
            new ColouredSurface(Colour.BLACK, Colour.BLACK));

    /** Checks all values, as {@link Parallelogram} does. */
    public Silhouette {
        Parallelogram area = new Parallelogram(description, corner, spanU, spanV, surface);
        corner = area.corner();
        spanU = area.spanU();
        spanV = area.spanV();
    }

    @Override
    public void addTo(PrimitiveCollector collector, Placement placement) {
        Surface cut = new CutOut(picture, surface, Clear.DEFAULT);
        Parallelogram area = new Parallelogram(description, corner, spanU, spanV, cut);
        collector.add(area.primitive(this, placement));
    }
}
