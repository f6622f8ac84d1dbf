package tompkins.primitive;

/** What a scene file describes and names; primitives belong to it. */
public interface Described {

    /** What the user calls it. */
    String description();

    /** Whether flat pieces of it bound a body, and are no sheets. */
    default boolean isBody() {
        return false;
    }
}
