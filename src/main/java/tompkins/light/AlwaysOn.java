package tompkins.light;

import tompkins.property.Meaning;

/** A lamp that shines all the time. */
@Meaning("The lamp shines all the time")
public record AlwaysOn() implements Flash {

    /** The only one. */
    public static final AlwaysOn DEFAULT = new AlwaysOn();

    @Override
    public boolean isLit(double ownTime) {
        return true;
    }
}
