package tompkins.studio;

import java.util.List;
import tompkins.light.LightSource;
import tompkins.property.Descriptions;

/** Studios with other light sources. */
public final class Lighting {

    private Lighting() {}

    /** The same studio with other light sources. */
    public static Studio of(Studio studio, List<LightSource> lights) {
        return Descriptions.with(studio, "lights", lights);
    }
}
