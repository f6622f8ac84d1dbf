package tompkins.property;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** One sentence that says what a description, or one of its properties, means to the user. */
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.RECORD_COMPONENT, ElementType.FIELD})
public @interface Meaning {

    /** The sentence, without the name of the property, without a full stop. */
    String value();

    /** The unit of the property, empty where it has none; lengths and times are in scene units (c = 1). */
    String unit() default "";

    /**
     * Whether the property is a place, which moves with what is described; lengths and differences of places do not.
     */
    boolean place() default false;

    /** Whether the property is a text that may have several lines. */
    boolean prose() default false;
}
