package tompkins.surface;

import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** What a boundary looks like and what it does to light. Descriptions, immutable, checked when they are made. */
public sealed interface Surface
        permits ColouredSurface,
                LuminousSurface,
                PictureSurface,
                Tiling,
                CutOut,
                Clear,
                ColourFilter,
                Mirror,
                Refractive,
                LorentzWindow,
                GalileoWindow {

    /** What becomes of a ray that hit this surface. */
    Response respond(Ray ray, Hit hit, Tracer tracer);

    /** Whether the surface needs {@link Hit#coordinates}. */
    default boolean usesCoordinates() {
        return false;
    }

    /** Whether the surface throws a shadow. */
    default Shadow shadow() {
        return Shadow.ALWAYS;
    }

    /** Whether a surface with {@link Shadow#BY_POINT} throws a shadow at a hit. */
    default boolean throwsShadowAt(Hit hit) {
        return shadow() == Shadow.ALWAYS;
    }

    /** Whether rays go on from here: mirrors, windows, glass. */
    default boolean continuesRays() {
        return false;
    }
}
