package tompkins.ui.model;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.UnaryOperator;
import tompkins.property.OneLine;
import tompkins.ui.widget.Texts;

/**
 * Where the settings are kept.
 *
 * @param path the folder, or null if there is none that can be used
 * @param trouble what the user should know about it; empty if it is where it was wanted
 */
record SettingsFolder(Path path, String trouble) {

    private static final String PROPERTY = "tompkins.settings";
    private static final String XDG = "XDG_CONFIG_HOME";
    private static final String PROGRAM = "tompkins";

    /** The folder that the system property names, or else the one for settings of the user. */
    static SettingsFolder find() {
        return find(System::getProperty, System::getenv);
    }

    /** As above, with the system's properties and the environment by their names; null for what is not set. */
    static SettingsFolder find(UnaryOperator<String> property, UnaryOperator<String> environment) {
        String chosen = property.apply(PROPERTY);
        if (chosen != null && !chosen.isEmpty()) {
            return of(chosen, "", "");
        }
        String windows = environment.apply("APPDATA");
        if (windows != null && !windows.isEmpty()) {
            return of(windows, PROGRAM, empty(chosen));
        }
        String linux = environment.apply(XDG);
        // an empty one is as if it were not set, by the XDG Base Directory Specification
        if (linux == null || linux.isEmpty()) {
            return ofHome(property, empty(chosen));
        }
        SettingsFolder folder = of(linux, PROGRAM, empty(chosen));
        // and so is a relative one
        return folder.path == null || folder.path.isAbsolute()
                ? folder
                : ofHome(property, Texts.get("settings.relative", XDG, OneLine.of(linux)));
    }

    private static String empty(String chosen) {
        return chosen == null ? "" : Texts.get("settings.empty", PROPERTY);
    }

    private static SettingsFolder ofHome(UnaryOperator<String> property, String trouble) {
        return of(property.apply("user.home") + "/.config", PROGRAM, trouble);
    }

    private static SettingsFolder of(String base, String name, String trouble) {
        try {
            return new SettingsFolder(Path.of(base).resolve(name), trouble);
        } catch (InvalidPathException notAName) {
            return new SettingsFolder(null, Texts.get("settings.noFolder", OneLine.of(base)));
        }
    }
}
