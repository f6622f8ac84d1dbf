/** What a picture models and what it leaves out, in sentences. */
package tompkins.explain;
