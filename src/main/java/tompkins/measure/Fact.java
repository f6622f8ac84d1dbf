package tompkins.measure;

import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3dc;

/**
 * One thing that is told about a ray or about what was measured. Texts, tables, JSON and the window are all made from
 * such facts, so that none of them has to know rays and measurements.
 */
public sealed interface Fact permits Quantity, Fact.Vector, Fact.Word, Fact.Flag, Fact.Group, Fact.Items {

    /** What programs call it; empty if it is told to people alone. */
    String key();

    /** What people call it; empty if it is told to programs alone. */
    String name();

    /**
     * Numbers that belong together.
     *
     * @param values the numbers
     */
    record Vector(String key, String name, List<Double> values) implements Fact {

        /** A vector of three numbers, or of none if it is null. */
        Vector(String key, String name, Vector3dc vector) {
            this(key, name, vector == null ? List.of() : List.of(vector.x(), vector.y(), vector.z()));
        }
    }

    /**
     * A text.
     *
     * @param text the text; null if there is none
     */
    record Word(String key, String name, String text) implements Fact {}

    /**
     * Whether something is so.
     *
     * @param value the answer
     */
    record Flag(String key, String name, boolean value) implements Fact {}

    /**
     * Facts under a heading.
     *
     * @param name the heading
     * @param facts the facts
     */
    record Group(String key, String name, List<Fact> facts) implements Fact {}

    /**
     * What happens one after the other.
     *
     * @param groups what happens; those without a key are told to people alone
     */
    record Items(String key, List<Group> groups) implements Fact {

        @Override
        public String name() {
            return key;
        }
    }

    /** The facts that are told to people. */
    static Stream<Fact> forPeople(List<? extends Fact> facts) {
        return facts.stream().filter(fact -> !fact.name().isEmpty()).map(Fact.class::cast);
    }

    /** The facts that are told to programs. */
    static Stream<Fact> forPrograms(List<? extends Fact> facts) {
        return facts.stream().filter(fact -> !fact.key().isEmpty()).map(Fact.class::cast);
    }
}
