package tompkins.app;

import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;
import tompkins.io.Spelling;
import tompkins.property.MistakeException;
import tompkins.studio.Ride;
import tompkins.studio.Studio;

/** The ride that is filmed: the one that is recorded in a scene, or one of its rides by name. */
final class RideOption {

    @Option(
            names = "--ride",
            arity = "0..1",
            fallbackValue = "",
            paramLabel = "NAME",
            description = "take the recorded ride, or the one of this name")
    private String name;

    /** Whether a ride is wanted. */
    boolean isGiven() {
        return name != null;
    }

    /** The scene; if none was given, what follows the option is not the name of a ride, but the scene. */
    Path scene(Path given) {
        if (given != null || name == null || name.isEmpty()) {
            return given;
        }
        Path scene = NamedFile.of(name);
        name = "";
        return scene;
    }

    /** The studio in which the ride begins. */
    Studio start(Studio studio, Path scene) {
        List<String> names = studio.rides().stream()
                .filter(ride -> !ride.legs().isEmpty())
                .map(Ride::name)
                .toList();
        String others = names.isEmpty() ? "" : "; its rides with legs are: " + String.join(", ", names);
        if (name.isEmpty()) {
            if (studio.ride().isEmpty()) {
                throw new MistakeException(
                        "--ride: no ride is recorded in " + scene + "; the window records one" + others);
            }
            return studio;
        }
        Ride named = studio.rides().stream()
                .filter(ride -> ride.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new MistakeException("--ride must be the name of a ride in " + scene + ", was \""
                        + name + "\"" + (names.isEmpty() ? "; it has none" : others) + Spelling.hint(name, names)));
        if (named.legs().isEmpty()) {
            throw new MistakeException("--ride: \"" + name + "\" is steered by hand and has no legs" + others);
        }
        return MistakeException.inOption("--ride", () -> named.start(studio));
    }
}
