package tompkins.app;

import picocli.CommandLine.IVersionProvider;

/** The version of the program, as its jar says. */
final class ProgramVersion implements IVersionProvider {

    private static final String UNPACKED = "(not packaged)";

    @Override
    public String[] getVersion() {
        String version = ProgramVersion.class.getPackage().getImplementationVersion();
        return new String[] {
            "Tompkins " + (version == null ? UNPACKED : version), "Java " + System.getProperty("java.version")
        };
    }
}
