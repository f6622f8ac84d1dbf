package tompkins.app;

import picocli.CommandLine.IVersionProvider;
import tompkins.io.SelfDescription;

/** The version of the program, and of Java. */
final class ProgramVersion implements IVersionProvider {

    @Override
    public String[] getVersion() {
        return new String[] {SelfDescription.program(), "Java " + System.getProperty("java.version")};
    }
}
