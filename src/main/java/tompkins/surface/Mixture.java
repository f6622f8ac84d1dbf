package tompkins.surface;

import tompkins.property.Meaning;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.ray.Hit;
import tompkins.ray.Ray;

/** Two surfaces at every point, each with its share of the light, as of threads too thin to be seen. */
@Meaning("Two surfaces at every point, each with its share of the light; with a clear one it is half transparent, and"
        + " throws no shadow")
public record Mixture(
        @Meaning("One surface") Surface first,
        @Meaning("The other surface") Surface second,
        @Meaning("Share of the second surface, from 0 to 1") double share)
        implements CompositeSurface {

    /** Half of white, half clear. */
    public static final Mixture DEFAULT =
            new Mixture(new ColouredSurface(Colour.WHITE, Colour.BLACK), Clear.DEFAULT, 0.5);

    /** Checks the share. */
    public Mixture {
        Require.within("share", share, 0.0, 1.0);
    }

    @Override
    public double fractionOfSecond(Ray ray, Hit hit) {
        return share;
    }

    /** Where light passes one of both there is no shadow. */
    @Override
    public Shadow shadow() {
        Shadow ofFirst = share == 1 ? Shadow.ALWAYS : first.shadow();
        Shadow ofSecond = share == 0 ? Shadow.ALWAYS : second.shadow();
        boolean isNever = ofFirst == Shadow.NEVER || ofSecond == Shadow.NEVER;
        return isNever ? Shadow.NEVER : ofFirst.orElsewhere(ofSecond);
    }
}
