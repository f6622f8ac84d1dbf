package tompkins.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine.Option;
import tompkins.io.Assignment;
import tompkins.io.Assignments;
import tompkins.io.StudioReader;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;

/** The option that gives other values to a scene before anything is done with it. */
class SetOption {

    /** Its name. */
    static final String NAME = "--set";

    @Option(
            names = NAME,
            paramLabel = "PATH=VALUE",
            description = "gives a key of the scene file another value, as written there, such as"
                    + " settings.toneCurve=srgb or scene[0].radius=2; also several times")
    private List<String> settings = new ArrayList<>();

    /** The values that were given. */
    List<Assignment> assignments() {
        return settings.stream().map(SetOption::assignment).toList();
    }

    private static Assignment assignment(String setting) {
        int equals = setting.indexOf('=');
        if (equals < 1) {
            throw new MistakeException(
                    NAME + " must be PATH=VALUE, such as settings.width=320, was " + OptionValues.shown(setting));
        }
        return new Assignment(NAME, setting.substring(0, equals), setting.substring(equals + 1));
    }

    /** The scene of a file with the values that were given, and others. */
    final Studio read(Path scene, List<Assignment> others) {
        return Assignments.applyTo(
                StudioReader.read(scene),
                Stream.concat(others.stream(), assignments().stream()).toList(),
                scene.toAbsolutePath().getParent());
    }
}
